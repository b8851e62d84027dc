//! Tests of the console, in one program: it links the graphics once.

mod compare;
mod conclusions;
mod drawn;
mod finding;
mod jobs;
mod learning;
mod machine;
mod panels;
mod plan;
mod screen;
mod screens;
mod shell;
mod weight;
mod windows;
mod workpiece;
