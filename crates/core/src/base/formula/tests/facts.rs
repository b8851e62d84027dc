//! What is read, printed, derived and simplified, case by case.

use super::super::*;
use super::read;

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

#[test]
fn latex_is_set_as_in_books() {
    for (text, latex) in [
        ("-x^2", r"-x^{2}"),
        ("(-2)^x", r"\left(-2\right)^{x}"),
        ("(x/y)^2", r"\left(\frac{x}{y}\right)^{2}"),
        ("(x - 1) * (y + 2)", r"\left(x - 1\right)\, \left(y + 2\right)"),
        ("5.82e-10 * x", r"5.82 \cdot 10^{-10}\, x"),
        ("x * 2", r"x \cdot 2"),
        ("x - (y - 1)", r"x - \left(y - 1\right)"),
        ("sqrt(x + 1) / 2", r"\frac{\sqrt{x + 1}}{2}"),
        ("exp(-pi * x)", r"\exp\left(-\pi\, x\right)"),
        ("1e-5^x", r"\left(1 \cdot 10^{-5}\right)^{x}"),
        ("x / (y / 2)", r"\frac{x}{\frac{y}{2}}"),
    ] {
        assert_eq!(read(text).export(FormulaLanguage::Latex, ""), latex, "{text}");
    }
    let named = Formula::parse("F_d * \"feed mm_min\"", &["F_d", "feed mm_min"]).unwrap();
    let latex = named.export(FormulaLanguage::Latex, "");
    assert_eq!(latex, r"F_{\mathrm{d}}\, \mathrm{feed~mm\_min}");
}

#[test]
fn the_names_of_a_text_are_its_inputs() {
    let names = Formula::names("ln(f) * \"a b\" + f - pi * n").unwrap();
    assert_eq!(names, ["f", "a b", "n"]);
    assert!(Formula::names("log(f)").unwrap_err().problem.contains("unknown function `log`"));
    assert!(Formula::names("f +").unwrap_err().problem.contains("ends here"));
}

#[test]
fn equations_are_shown_with_raised_powers_and_other_words() {
    for (text, shown) in [
        ("5.82e-10*x^3", "5.82·10^{-10} · a^3"),
        ("(x/256)^-0.245", "(a / 256)^{-0.245}"),
        ("-x^2 - -3*sqrt(y)", "-a^2 - -3 · √((-7))"),
        ("x / (2e-9 * y)", "a / (2·10^{-9} · (-7))"),
        ("2^(x + 1)", "pow(2, a + 1)"),
        ("x * -y", "a · (-(-7))"),
        ("1e-9^x", "(1·10^{-9})^a"),
        ("exp(x)^y", "exp(a)^{(-7)}"),
    ] {
        assert_eq!(read(text).equation(&["a", "(-7)"]), shown, "{text}");
    }
}
