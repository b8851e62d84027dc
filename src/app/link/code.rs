//! The QR code of a link (ISO/IEC 18004): drawn in sharp squares, black on white in every theme, with its quiet zone,
//! and written as SVG and PNG.

use egui::{Color32, Mesh, Rect, Response, Role, Sense, Shape, Ui, Vec2, WidgetInfo, pos2, vec2};
use miniz_oxide::deflate::compress_to_vec_zlib;
use qrcode::{Color, EcLevel, QrCode};

use crate::base::crc32::crc32;
use crate::base::language::tr;

/// Width of the white rim, squares.
const QUIET: usize = 4;
/// Most bytes that a code holds, at the least correction.
const MOST_BYTES: usize = 2953;
/// Links up to so many bytes get a code that bears more damage (chosen).
const SHORT_BYTES: usize = 300;
/// Least side of a picture, pixels.
const PICTURE: usize = 900;

/// A code.
#[derive(Clone, Debug)]
pub struct LinkCode {
    /// Squares along a side, without the rim.
    side: usize,
    dark: Vec<bool>,
}

impl LinkCode {
    /// The code of a link.
    ///
    /// # Errors
    /// The link is too long for any.
    pub fn of(link: &str) -> Result<Self, String> {
        let level = if link.len() <= SHORT_BYTES { EcLevel::M } else { EcLevel::L };
        let code = QrCode::with_error_correction_level(link, level).map_err(|_| {
            tr!(
                "This link has {bytes} characters, and a QR code holds {most} at most: send the link itself.",
                bytes = link.len(),
                most = MOST_BYTES
            )
        })?;
        let dark = code.to_colors().into_iter().map(|color| color == Color::Dark).collect();
        Ok(Self { side: code.width(), dark })
    }

    /// Squares along a side with the rim.
    fn whole(&self) -> usize {
        self.side + 2 * QUIET
    }

    /// The dark runs of squares: column and row of the first one, counted with the rim, and how many there are.
    fn runs(&self) -> impl Iterator<Item = [usize; 3]> + '_ {
        self.dark.chunks(self.side).enumerate().flat_map(|(row, squares)| {
            let mut column = 0;
            let runs = squares.chunk_by(|a, b| a == b).map(move |run| {
                let first = column;
                column += run.len();
                (run[0], [first + QUIET, row + QUIET, run.len()])
            });
            runs.filter_map(|(dark, run)| dark.then_some(run)).collect::<Vec<_>>()
        })
    }

    /// The picture as SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        let whole = self.whole();
        let path: String =
            self.runs().map(|[x, y, count]| format!("M{x} {y}h{count}v1h-{count}z")).collect();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {whole} {whole}\" shape-rendering=\"crispEdges\">\n\
             <path fill=\"#fff\" d=\"M0 0h{whole}v{whole}H0z\"/>\n<path d=\"{path}\"/>\n</svg>\n"
        )
    }

    /// The picture as PNG (ISO/IEC 15948), a bit to the pixel.
    #[must_use]
    pub fn png(&self) -> Vec<u8> {
        let scale = PICTURE.div_ceil(self.whole());
        let side = scale * self.whole();
        let mut white = vec![true; side * side];
        for [x, y, count] in self.runs() {
            for line in scale * y..scale * (y + 1) {
                white[line * side + scale * x..][..scale * count].fill(false);
            }
        }
        let mut lines = Vec::with_capacity(side * (side / 8 + 2));
        for line in white.chunks(side) {
            // No filter.
            lines.push(0);
            lines.extend(line.chunks(8).map(|bits| {
                let bit = |(at, white): (usize, &bool)| u8::from(*white) << (7 - at);
                bits.iter().enumerate().map(bit).sum::<u8>()
            }));
        }
        let size = (side as u32).to_be_bytes();
        let mut png = b"\x89PNG\r\n\x1a\n".to_vec();
        // One bit, grey, the only compression and filter, not interlaced.
        chunk(&mut png, b"IHDR", &[&size[..], &size, &[1, 0, 0, 0, 0]].concat());
        chunk(&mut png, b"IDAT", &compress_to_vec_zlib(&lines, 9));
        chunk(&mut png, b"IEND", &[]);
        png
    }

    /// Draws it, at most `most` points wide, each square on whole pixels.
    pub fn show(&self, ui: &mut Ui, most: f32) -> Response {
        let pixel = 1.0 / ui.pixels_per_point();
        let whole = self.whole() as f32;
        let square = (most / (whole * pixel)).floor().max(1.0) * pixel;
        let (place, response) = ui.allocate_exact_size(Vec2::splat(square * whole), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, tr("QR code of the link")));
        let on_pixel = |x: f32| (x / pixel).round() * pixel;
        let corner = pos2(on_pixel(place.left()), on_pixel(place.top()));
        // Rectangles of shapes have soft edges, those of a mesh have none.
        let mut mesh = Mesh::default();
        let all = Rect::from_min_size(corner, Vec2::splat(square * whole));
        mesh.add_colored_rect(all, Color32::WHITE);
        for [x, y, count] in self.runs() {
            let from = corner + square * vec2(x as f32, y as f32);
            let size = square * vec2(count as f32, 1.0);
            mesh.add_colored_rect(Rect::from_min_size(from, size), Color32::BLACK);
        }
        ui.painter().add(Shape::mesh(mesh));
        response
    }
}

/// Adds a part of a PNG: its length, kind and bytes, and the CRC of the latter.
fn chunk(png: &mut Vec<u8>, kind: &[u8; 4], bytes: &[u8]) {
    png.extend((bytes.len() as u32).to_be_bytes());
    let from = png.len();
    png.extend(kind);
    png.extend(bytes);
    let crc = crc32(&png[from..]);
    png.extend(crc.to_be_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The text of the code on a picture in grey, by a decoder of other people's.
    fn decoded(side: usize, grey: impl Fn(usize, usize) -> u8) -> String {
        let mut picture = rqrr::PreparedImage::prepare_from_greyscale(side, side, grey);
        let grids = picture.detect_grids();
        assert_eq!(grids.len(), 1, "one code");
        grids[0].decode().expect("it can be read").1
    }

    fn links() -> [String; 3] {
        let long =
            |count: usize| format!("https://example.org/steadycut/#v=1&z={}", "Qx7".repeat(count));
        ["https://example.org/#mission=quiet-speed".to_owned(), long(100), long(900)]
    }

    #[test]
    fn the_saved_picture_is_read_again() {
        for link in links() {
            let png = LinkCode::of(&link).unwrap().png();
            let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
            decoder.set_transformations(png::Transformations::normalize_to_color8());
            let mut reader = decoder.read_info().unwrap();
            let mut grey = vec![0; reader.output_buffer_size().unwrap()];
            let info = reader.next_frame(&mut grey).unwrap();
            assert_eq!((info.width, info.color_type), (info.height, png::ColorType::Grayscale));
            let side = info.width as usize;
            assert!(side >= PICTURE);
            assert_eq!(decoded(side, |x, y| grey[y * side + x]), link);
        }
    }

    #[test]
    fn the_drawing_is_read_again_and_has_its_rim() {
        for link in links() {
            let code = LinkCode::of(&link).unwrap();
            let svg = code.svg();
            let path = svg.split("d=\"M").nth(2).unwrap().split('"').next().unwrap();
            let whole = code.whole();
            let mut dark = vec![false; whole * whole];
            for run in path.split('M') {
                let (x, rest) = run.split_once(' ').unwrap();
                let (y, rest) = rest.split_once('h').unwrap();
                let count = rest.split('v').next().unwrap();
                let [x, y, count]: [usize; 3] = [x, y, count].map(|number| number.parse().unwrap());
                dark[y * whole + x..][..count].fill(true);
                for place in [x, y, whole - x - count, whole - y - 1] {
                    assert!(place >= QUIET, "{place}");
                }
            }
            let grey = |x: usize, y: usize| if dark[y / 4 * whole + x / 4] { 0 } else { 255 };
            assert_eq!(decoded(4 * whole, grey), link);
        }
    }

    #[test]
    fn a_link_that_is_too_long_says_so() {
        let link = |bytes: usize| "x".repeat(bytes);
        assert!(LinkCode::of(&link(MOST_BYTES)).is_ok());
        let said = LinkCode::of(&link(MOST_BYTES + 1)).unwrap_err();
        assert!(said.contains("2954") && said.contains("2953"), "{said}");
    }
}
