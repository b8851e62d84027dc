//! Tests of the command line and of what it is the way to, in one program: it links once.

mod architecture;
mod combined;
mod commands;
mod contributing;
mod documents;
mod experimenting;
mod formulas;
mod identifying;
mod jobs;
mod manual;
mod planning;
mod profilometer;
mod program;
mod reading;
mod recommending;
mod training;
mod uses;
mod wear;
mod writing;
