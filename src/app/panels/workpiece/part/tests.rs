use super::*;
use crate::app::scene::mesh::CORNER_BYTES;
use crate::blocks::surface::topography::ToothMark;

/// Place and normal of every corner.
fn corners(mesh: &Mesh) -> Vec<[Point; 2]> {
    let number = |bytes: &[u8], i: usize| {
        f32::from_ne_bytes(bytes[4 * i..4 * i + 4].try_into().expect("four bytes"))
    };
    let corner =
        |bytes: &[u8]| [[0, 1, 2], [3, 4, 5]].map(|numbers| numbers.map(|i| number(bytes, i)));
    mesh.corners.chunks_exact(CORNER_BYTES).map(corner).collect()
}

fn marked(radius: f64, to: f64) -> Topography {
    let mut surface = Topography::new(Outline::ball(radius), 1);
    for k in 0..(to / 0.2) as i32 {
        surface.push(ToothMark { x_mm: 0.2 * f64::from(k), z_mm: 0.001, ra_um: 0.0 });
    }
    surface
}

fn drawn(cut: &CutPath, surface: &Topography, tool: f32, times: f32) -> Mesh {
    let part = Part {
        cut,
        surface,
        tool_mm: tool,
        window_mm: [tool - 20.0, tool + 20.0],
        times,
        stock: Color32::GRAY,
        color: &|_| Color32::GREEN,
    };
    let mut mesh = Mesh::default();
    part.draw(&mut mesh);
    mesh
}

#[test]
fn every_corner_is_finite_within_the_part_and_has_a_normal() {
    let steps = [[30.0, 2.6, 2.0], [9.0, 4.75, 0.0], [21.0, 2.75, 2.0]];
    for cut in [CutPath::new(&steps), CutPath::open(&steps), CutPath::new(&[[5.0, 9.0, -8.0]])] {
        let [low, high] = bounds(&cut, &Outline::ball(8.0));
        for tool in [-7.6, 0.0, 0.1, 15.0, 29.99, 30.0, 33.0, 60.0, 61.0] {
            let mesh = drawn(&cut, &marked(8.0, f64::from(tool)), tool, 50.0);
            let corners = corners(&mesh);
            assert!(mesh.triangles.iter().all(|i| (*i as usize) < corners.len()));
            for [place, normal] in corners {
                for i in 0..3 {
                    // The heights are drawn larger.
                    let inside = (low[i] - 0.2..=high[i] + 0.2).contains(&place[i]);
                    assert!(inside, "{place:?} at {tool}");
                }
                let length = normal.iter().map(|x| x * x).sum::<f32>().sqrt();
                assert!((length - 1.0).abs() < 1e-3, "{normal:?} at {tool}");
            }
        }
    }
}

#[test]
fn heights_are_drawn_larger_by_the_factor() {
    let cut = CutPath::new(&[[40.0, 2.0, 2.0]]);
    let surface = marked(8.0, 30.0);
    let heights = |times: f32| {
        let mesh = drawn(&cut, &surface, 30.0, times);
        let corners = corners(&mesh);
        // Within the strip, off its borders.
        let within = corners.into_iter().filter(|[place, normal]| {
            (2.1..5.0).contains(&place[1]) && (11.0..28.0).contains(&place[0]) && normal[2] > 0.5
        });
        let ball = |y: f32| 8.0 - (64.0 - y * y).sqrt();
        within.map(|[place, _]| place[2] - ball(place[1])).collect::<Vec<f32>>()
    };
    let (once, often) = (heights(1.0), heights(100.0));
    assert!(once.len() > 1000, "{}", once.len());
    for (small, large) in once.iter().zip(&often) {
        assert!((0.000_99..0.0018).contains(small), "{small}");
        assert!((large - 100.0 * small).abs() < 2e-4, "{small} {large}");
    }
}

#[test]
fn the_faces_of_a_step_close_it() {
    // Seen along the cut, the upright faces at a step cover what differs between the sections.
    let cut = CutPath::new(&[[30.0, 2.0, 2.0], [30.0, 3.0, 0.0]]);
    let mesh = drawn(&cut, &marked(8.0, 60.0), 60.0, 1.0);
    let corners = corners(&mesh);
    let area: f32 = mesh
        .triangles
        .chunks_exact(3)
        .map(|t| [t[0], t[1], t[2]].map(|i| corners[i as usize]))
        .filter(|t| t.iter().all(|[place, normal]| place[0] == 30.0 && normal[0].abs() > 0.9))
        .map(|t| {
            let [a, b, c] = t.map(|[place, _]| place);
            0.5 * ((b[1] - a[1]) * (c[2] - a[2]) - (c[1] - a[1]) * (b[2] - a[2])).abs()
        })
        .sum();
    // Between the two outlines: the wall from 0 to 2, from the floor to the ball; from where the
    // ball meets 2 mm up to 3 mm; and behind it 1 mm.
    let ball = |y: f64| 8.0 - (64.0 - y * y).sqrt();
    let count = 100_000;
    let back = 39.0_f64.sqrt() + 6.0;
    let exact: f64 = (0..count)
        .map(|i| back * (f64::from(i) + 0.5) / f64::from(count))
        .map(|y| {
            let top = |wall: f64, depth: f64| match y {
                y if y < wall => -0.6,
                y => ball(y.min(7.99)).min(depth),
            };
            (top(2.0, 2.0) - top(0.0, 3.0)).abs() * back / f64::from(count)
        })
        .sum();
    assert!((f64::from(area) / exact - 1.0).abs() < 0.01, "{area} {exact}");
}
