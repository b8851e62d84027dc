//! Tests of the console, in one program: it links the graphics once.

mod compare;
mod conclusions;
mod contrast;
mod drawn;
mod finding;
mod fingers;
mod formulas;
mod identify;
mod jobs;
mod judged;
mod learning;
mod legible;
mod machine;
mod panels;
mod plan;
mod screen;
mod screens;
mod shell;
mod views;
mod weight;
mod windows;
mod workpiece;
