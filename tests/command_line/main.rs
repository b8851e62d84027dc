//! Tests of the command line and of what it is the way to, in one program: it links once.

mod afc;
mod architecture;
mod combined;
mod commands;
mod contributing;
mod documents;
mod experimenting;
mod formulas;
mod identifying;
mod jobs;
mod languages;
mod manual;
mod measuring;
mod missions;
mod packing;
mod planning;
mod profilometer;
mod program;
mod reading;
mod recommending;
mod scripts;
mod training;
mod twin;
mod uses;
mod wear;
mod writing;
