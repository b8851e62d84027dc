//! Formulas at random: what is printed reads back, what is derived and simplified has the values it should.

use proptest::prelude::*;

use super::*;

const INPUTS: [&str; 3] = ["x", "y", "feed rate"];

/// Any number that a formula may have.
fn numbers() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-9_i32..10).prop_map(f64::from),
        (-20_i32..20).prop_map(|x| f64::from(x) * 0.5),
        -10.0..10.0,
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
    ]
}

fn leaves() -> impl Strategy<Value = Node> {
    prop_oneof![
        numbers().prop_map(Node::Number),
        (0..INPUTS.len()).prop_map(Node::Input),
        Just(Node::Constant(NamedConstant { name: "pi".to_owned(), value: math::PI })),
    ]
}

/// Any formula.
fn formulas() -> impl Strategy<Value = Formula> {
    let node = leaves().prop_recursive(7, 60, 2, |inner| {
        let (function, operator) =
            (prop::sample::select(&Function::ALL[..]), prop::sample::select(&Operator::ALL[..]));
        prop_oneof![
            (function, inner.clone()).prop_map(|(function, node)| Node::unary(function, node)),
            (operator, inner.clone(), inner).prop_map(|(o, a, b)| Node::binary(o, a, b)),
        ]
    });
    node.prop_map(|root| Formula::new(root, &INPUTS).expect("small"))
}

/// A value, and by how much rounding alone may have changed it.
fn rounded(node: &Node, at: &[f64]) -> (f64, f64) {
    let value = node.value(at);
    let error = match node {
        Node::Number(_) | Node::Input(_) | Node::Constant(_) => 0.0,
        Node::Unary(function, operand) => {
            let (x, error) = rounded(operand, at);
            let [low, high] = [x - error, x + error].map(|x| (function.at(x) - value).abs());
            2.0 * low.max(high)
        }
        Node::Binary(operator, pair) => {
            let [(a, of_a), (b, of_b)] = [rounded(&pair[0], at), rounded(&pair[1], at)];
            let corners = [(a - of_a, b), (a + of_a, b), (a, b - of_b), (a, b + of_b)];
            // Across a pole or a place without a value, anything may be.
            let crosses = |x: f64, error: f64| x.abs() <= error && error > 0.0;
            let apart = match operator {
                Operator::Add | Operator::Subtract | Operator::Multiply => false,
                Operator::Divide => crosses(b, of_b),
                Operator::Power => of_b > 0.0 || crosses(a, of_a),
            };
            let errors = corners.map(|(a, b)| (operator.at(a, b) - value).abs());
            if apart { f64::INFINITY } else { 2.0 * errors.into_iter().sum::<f64>() }
        }
    };
    (value, if error.is_nan() { f64::INFINITY } else { error + 64.0 * f64::EPSILON * value.abs() })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn what_is_printed_reads_back_to_the_bit(formula in formulas()) {
        let text = formula.to_string();
        let read = Formula::parse(&text, &INPUTS).map_err(|e| TestCaseError::fail(e.to_string()))?;
        prop_assert_eq!(&format!("{read:?}"), &format!("{formula:?}"), "{}", text);
        let (_, spans) = parse::parse(&text, &INPUTS, &[]).unwrap();
        prop_assert_eq!(spans.len(), formula.size());
        let printed = text::print(&formula).1;
        prop_assert_eq!(spans.len(), printed.len());
    }

    #[test]
    fn the_compiled_form_has_the_same_bits(formula in formulas(), at in [-3.0..3.0, -3.0..3.0, 0.0..1e3]) {
        let [compiled, value] = [formula.compile().value(&at), formula.value(&at)];
        prop_assert!(compiled.to_bits() == value.to_bits() || compiled.is_nan() && value.is_nan());
    }

    #[test]
    fn derivatives_are_the_limits_of_differences(
        formula in formulas(),
        at in [0.1..3.0, 0.1..3.0, 0.1..9.0],
        input in 0..3_usize,
    ) {
        let difference = |step: f64| {
            let [mut up, mut down] = [at, at];
            (up[input], down[input]) = (at[input] + step, at[input] - step);
            (formula.value(&up) - formula.value(&down)) / (2.0 * step)
        };
        let [coarse, fine] = [difference(2e-5), difference(1e-5)];
        let noise = rounded(formula.root(), &at).1 / 1e-5;
        let doubt = 2.0 * (coarse - fine).abs() + 4.0 * noise + 1e-7 * fine.abs();
        let finite = has_values(formula.root(), &at);
        if finite && doubt.is_finite() && doubt < 1e-3 * fine.abs().max(1e-3) {
            let slope = formula.derivative(input).map_err(TestCaseError::fail)?.value(&at);
            prop_assert!((slope - fine).abs() <= doubt, "{}: {} and {}", formula, slope, fine);
        }
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in r#"[-+*/^()., 0-9a-zA-Zµ"$]{0,40}"#) {
        if let Err(error) = Formula::parse(&text, &INPUTS) {
            prop_assert!(error.column <= text.chars().count() + 1, "{}", error);
            prop_assert!(error.picture.contains('^'));
        }
    }

    #[test]
    fn what_is_simplified_has_the_same_values(
        formula in formulas(),
        at in [-3.0..3.0, -3.0..3.0, 0.1..9.0],
    ) {
        let simple = formula.simplified();
        prop_assert!(simple.size() <= formula.size());
        let [(expected, before), (value, after)] =
            [rounded(formula.root(), &at), rounded(simple.root(), &at)];
        if (before + after).is_finite() && expected.abs() < 1e200 {
            let close = (value - expected).abs() <= before + after;
            prop_assert!(close, "{} for {}: {} and {}", simple, formula, value, expected);
        }
        // Where there is no value round about, and not for want of range, there is none afterwards.
        let near = [0.999, 1.0, 1.001].map(|near| at.map(|x| x * near));
        if near.iter().all(|at| formula.value(at).is_nan() && largest(formula.root(), at) < 1e100) {
            prop_assert!(!value.is_finite(), "{} for {}", simple, formula);
        }
    }
}

/// Whether every part has a value.
fn has_values(node: &Node, at: &[f64]) -> bool {
    node.value(at).abs() < 1e100 && node.operands().iter().all(|operand| has_values(operand, at))
}

/// The largest magnitude of any part.
fn largest(node: &Node, at: &[f64]) -> f64 {
    let inside = node.operands().iter().map(|operand| largest(operand, at));
    inside.fold(node.value(at).abs(), f64::max)
}

/// A formula of x and y.
fn read(text: &str) -> Formula {
    Formula::parse(text, &["x", "y"]).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn precedence_is_that_of_mathematics() {
    for (text, expected) in [
        ("-3^2", -9.0),
        ("(-3)^2", 9.0),
        ("2^3^2", 512.0),
        ("(2^3)^2", 64.0),
        ("2^-1", 0.5),
        ("-2^-2", -0.25),
        ("10 - 4 - 3", 3.0),
        ("24 / 4 / 3", 2.0),
        ("2 + 3 * 4", 14.0),
        ("--3", 3.0),
        ("2*-3", -6.0),
        (".5e1", 5.0),
        ("1.E-2", 0.01),
        ("cos(pi)", -1.0),
        ("ln(e)", 1.0),
    ] {
        assert_eq!(read(text).value(&[]), expected, "{text}");
    }
}

#[test]
fn a_text_has_as_few_parentheses_as_it_needs() {
    for (text, printed) in [
        ("((x))+(y)", "x + y"),
        ("x-(y-1)", "x - (y - 1)"),
        ("(x-y)-1", "x - y - 1"),
        ("x/(y*2)", "x / (y * 2)"),
        ("(x^2)^3", "(x^2)^3"),
        ("x^(2^3)", "x^2^3"),
        ("-(x*y)", "-(x * y)"),
        ("(-x)*y", "-x * y"),
        ("(-2)^x", "(-2)^x"),
        ("-(2^x)", "-2^x"),
        ("x^(-y)", "x^-y"),
        ("sqrt((x+1))", "sqrt(x + 1)"),
        ("5.82E-010*x", "5.82e-10 * x"),
        ("1000000*x", "1000000 * x"),
    ] {
        assert_eq!(read(text).to_string(), printed);
    }
    assert_eq!(read("x + -2").size(), 3, "a negative number is one node");
}

#[test]
fn faults_are_told_with_their_place() {
    for (text, column, part) in [
        ("", 1, "expected a number, a name, a function or `(`, but the formula ends here"),
        ("x +", 4, "the formula ends here"),
        ("x * (y + 1", 11, "expected `)`"),
        ("2 x", 3, "a product needs its `*`"),
        ("0,5 * x", 2, "a decimal point, not a comma"),
        ("x + speeed", 5, "known are x, y"),
        ("log(x)", 1, "the natural logarithm is `ln`"),
        ("sqr(x)", 1, "did you mean `sqrt`?"),
        ("tan(x)", 1, "did you mean `tanh`?"),
        ("X + y", 1, "did you mean `x`?"),
        ("ln x", 4, "`(` behind the function `ln`"),
        ("x ** 2", 4, "found `*`"),
        ("x % 2", 3, "`%` has no meaning"),
        ("µ + x", 1, "unknown name `µ`"),
        ("x + 1e999", 5, "too large"),
        ("\"x", 1, "without its end"),
        ("x)", 2, "the end"),
    ] {
        let error = Formula::parse(text, &["x", "y"]).unwrap_err();
        assert_eq!(error.column, column, "{text}: {error}");
        assert!(error.problem.contains(part), "{text}: {error}");
        let carets = error.picture.lines().nth(1).unwrap_or_default();
        assert_eq!(carets.find('^'), Some(column + 1), "{error}");
    }
}

#[test]
fn too_deep_or_too_large_is_refused_without_a_fall() {
    let deep = |n: usize| format!("{}x{}", "(".repeat(n), ")".repeat(n));
    assert!(Formula::parse(&deep(90), &["x"]).is_ok());
    for text in [
        deep(40_000),
        "(".repeat(90_000),
        "-".repeat(90_000),
        "ln(".repeat(30_000),
        "x^".repeat(40_000),
        "x+".repeat(40_000),
        format!("{}x", "x*".repeat(200)),
        format!("{}x{}", "(".repeat(99), "+x)*x".repeat(99)),
    ] {
        let error = Formula::parse(&text, &["x"]).unwrap_err();
        assert!(error.problem.contains("nested more than 100 deep"), "{error}");
    }
    let wide = vec!["(x+x+x+x+x+x+x+x)"; 60].join("*");
    assert!(Formula::parse(&wide, &["x"]).is_ok());
    let wide = vec![format!("({wide})"); 6].join("*");
    let error = Formula::parse(&wide, &["x"]).unwrap_err();
    assert!(error.problem.contains("more than 4000 nodes"), "{error}");
    let error = Formula::parse(&" ".repeat(200_000), &["x"]).unwrap_err();
    assert!(error.problem.contains("100000"), "{error}");
}

#[test]
fn names_and_numbers_that_no_formula_can_have_are_refused() {
    assert!(Formula::parse("x", &["x", "x"]).is_err());
    assert!(Formula::new(Node::Number(f64::NAN), &["x"]).unwrap_err().contains("NaN"));
    assert!(Formula::new(Node::Input(1), &["x"]).unwrap_err().contains("input 1"));
    let sign = Node::Unary(Function::Negative, Box::new(Node::Number(2.0)));
    assert!(Formula::new(sign, &["x"]).is_err());
    let own = [NamedConstant { name: "g".to_owned(), value: 9.81 }];
    let formula = Formula::parse_with("g * \"a b\"", &["a b"], &own).unwrap();
    assert_eq!(formula.value(&[2.0]), 19.62);
    assert_eq!(formula.to_string(), "g * \"a b\"");
    assert_eq!(
        Formula::parse("pi", &["pi"]).unwrap().root(),
        &Node::Input(0),
        "an input goes first"
    );
}

#[test]
fn derivatives_are_those_of_the_tables() {
    for (text, derivative) in [
        ("3", "0"),
        ("y", "0"),
        ("x", "1"),
        ("x^3", "3 * x^2"),
        ("ln(x)", "1 / x"),
        ("exp(2*x)", "2 * exp(2 * x)"),
        ("sqrt(x)", "0.5 / sqrt(x)"),
        ("sin(x)", "cos(x)"),
        ("-y*x", "-y"),
        ("2^x", "0.6931471805599453 * 2^x"),
    ] {
        assert_eq!(read(text).derivative(0).unwrap().to_string(), derivative, "{text}");
    }
}

#[test]
fn simplification_does_what_people_expect() {
    for (text, simple) in [
        ("2 + 3", "5"),
        ("x + 0", "x"),
        ("x * 1", "x"),
        ("x * 0", "0"),
        ("0 * ln(x)", "0 * ln(x)"),
        ("x + x", "2 * x"),
        ("2*x*y + 3*y*x", "5 * x * y"),
        ("x - x", "0"),
        ("x / x", "x / x"),
        ("x * x", "x^2"),
        ("x^2 * x^3", "x^5"),
        ("sqrt(x) * sqrt(x)", "sqrt(x)^2"),
        ("x^0.3 * x^0.7", "x^0.3 * x^0.7"),
        ("x^0.5", "sqrt(x)"),
        ("2 * (3 * x)", "6 * x"),
        ("(x / 2) / 3", "x / 6"),
        ("2 * x / 3", "0.6666666666666666 * x"),
        ("-(x - y)", "y - x"),
        ("x - -2", "x + 2"),
        ("x + -2 * y", "x - 2 * y"),
        ("-x + y", "y - x"),
        ("x^-2 * y", "y / x^2"),
        ("x^1", "x"),
        ("x^0", "1"),
        ("x / 3", "x / 3"),
        ("pi * 2 * x", "2 * pi * x"),
        ("x^40 * x^40", "x^40 * x^40"),
    ] {
        assert_eq!(read(text).simplified().to_string(), simple, "{text}");
    }
}
