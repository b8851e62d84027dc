# Texts of the program, written by its tests: see ARCHITECTURE.md.

## crates/measured/src/assemble.rs

the-times-in-name-have-no-unit-taken-to-be-s = the times in `{ $name }` have no unit: taken to be s
the-times-in-name-have-the-unit-unit-which-i = the times in `{ $name }` have the unit `{ $unit }`, which is none of time: taken to be s
the-times-in-name-do-not-go-on-at-sample-sam = the times in `{ $name }` do not go on at sample { $sample }
key-has-count-entries = `{ $key }` has { $count } entries
one-for-each-of-the-count-columns-names = one for each of the { $count } columns: { $names }
there-is-no-column-name-for-the-times = there is no column { $name } for the times
none-or-one-of-names = none, or one of { $names }

## crates/measured/src/bytes.rs

the-file-ends-left-bytes-behind-it = the file ends { $left } bytes behind it
count-bytes = { $count } bytes

## crates/measured/src/contents/mod.rs

count-records = { $count } records
the-number-of-one-as-in-name-1 = the number of one, as in { $name }[1]
real-numbers = real numbers
numbers-or-a-record = numbers or a record
a-vector-of-numbers-in-it = a vector of numbers in it
record-number-of-count-in-name-choose-anothe = record { $number } of { $count } in `{ $name }`; choose another one by variable={ $name }[{ $count }]
the-file-holds-no-variables = the file holds no variables
the-file-holds-names = the file holds { $names }
a-vector-of-numbers = a vector of numbers
name-was-left-out-about = `{ $name }` was left out: { $about }

## crates/measured/src/contents/value.rs

size-complex-numbers = { $size } complex numbers
size-numbers = { $size } numbers
the-text-text = the text { $text }
count-cells = { $count } cells
count-records-of-fields = { $count } records of { $fields }
there-is-no-name = there is no { $name }
one-of-names = one of { $names }
number-part = number { $part }
t-1-to-most = 1 to { $most }
something-with-a-part-in-it = something with a { $part } in it

## crates/measured/src/fault.rs

found-expected-is-expected = { $found }; expected is { $expected }
line-line-column-column-name-what = line { $line }, column { $column } ({ $name }): { $what }
byte-byte-what = byte { $byte }: { $what }

## crates/measured/src/hdf5/arrays.rs

an-array-of-chunks = an array of chunks
elements-of-kind-kind-with-size-bytes = elements of kind { $kind } with { $size } bytes
those-of-an-array-of-chunks = those of an array of chunks
numbers-of-bits-bits = numbers of { $bits } bits
at-most-63 = at most 63
more-values-than-a-file-of-this-size-can-hav = more values than a file of this size can have
blocks-of-least-elements = blocks of { $least } elements
a-power-of-two = a power of two

## crates/measured/src/hdf5/attributes.rs

an-attribute = an attribute

## crates/measured/src/hdf5/btree2.rs

a-tree = a tree
a-tree-of-kind-kind = a tree of kind { $kind }
a-tree-of-depth-depth = a tree of depth { $depth }
at-most-most = at most { $most }
count-records-in-a-node = { $count } records in a node
a-node-of-size-bytes = a node of { $size } bytes

## crates/measured/src/hdf5/chunks.rs

an-array-of-size-bytes = an array of { $size } bytes
a-tree-of-kind-kind-level-level = a tree of kind { $kind }, level { $level }
kind-1-below-level-most = kind 1, below level { $most }

## crates/measured/src/hdf5/datatype.rs

types-more-than-depth-deep-in-each-other = types more than { $depth } deep in each other
a-type = a type
a-type-of-no-bytes = a type of no bytes
at-least-one = at least one
times = times
bytes-without-a-meaning = bytes without a meaning
references-to-parts-of-arrays = references to parts of arrays
size-bytes = { $size } bytes
complex-numbers = complex numbers
a-type-of-class-class = a type of class { $class }
t-0-to-11 = 0 to 11
whole-numbers-of-more-than-64-bits = whole numbers of more than 64 bits
bits-bits-from-bit-shift-on = { $bits } bits from bit { $shift } on
within-size-bytes = within { $size } bytes
floats-of-an-unusual-form = floats of an unusual form
bytes-bytes-from-byte-at-on = { $bytes } bytes from byte { $at } on
count-elements-of-bytes-bytes = { $count } elements of { $bytes } bytes

## crates/measured/src/hdf5/decode.rs

elements-that-are-arrays = elements that are arrays
references-to-other-objects = references to other objects
texts = texts
lists-of-different-lengths = lists of different lengths

## crates/measured/src/hdf5/file.rs

numbers-of-size-bytes = numbers of { $size } bytes
at-most-8 = at most 8
version-version-of-what = version { $version } of { $what }
one-that-is-known = one that is known
no-signature-of-hdf5 = no signature of HDF5
one-at-byte-0-512-1024 = one at byte 0, 512, 1024, ...
addresses-of-size-bytes = addresses of { $size } bytes
t-2-4-or-8 = 2, 4 or 8
hdf5 = HDF5
a-file-of-size-bytes = a file of { $size } bytes
no-root-group = no root group
its-address = its address
no-address = no address
one = one
the-address-address = the address { $address }
the-bytes-bytes = the bytes { $bytes }
parts-of-the-file-that-name-each-other-again = parts of the file that name each other again and again
each-of-them-once = each of them once
a-part-of-the-file-whose-checksum-does-not-f = a part of the file whose checksum does not fit
one-that-does = one that does

## crates/measured/src/hdf5/filters.rs

a-list-of-filters = a list of filters
compressed-by-szip-which-is-not-read = compressed by szip, which is not read
compressed-by-blosc-which-is-not-read = compressed by Blosc, which is not read
compressed-in-a-way-that-is-not-read = compressed in a way that is not read
compressed-bytes-that-are-spoilt = compressed bytes that are spoilt
a-chunk = a chunk
a-chunk-of-size-bytes = a chunk of { $size } bytes
values-whose-checksum-does-not-fit = values whose checksum does not fit
those-that-were-written = those that were written

## crates/measured/src/hdf5/header.rs

an-object-s-header = an object's header
a-message-that-is-shared = a message that is shared
a-message-in-the-heap-of-messages-that-are-s = a message in the heap of messages that are shared
one-in-an-object-s-header = one in an object's header
an-object-without-the-message-that-it-should = an object without the message that it should share
one-with-it = one with it

## crates/measured/src/hdf5/heaps.rs

a-name-without-an-end = a name without an end
a-zero-behind-it = a zero behind it
a-text-of-length-bytes = a text of { $length } bytes
one-that-the-heap-has = one that the heap has
a-heap = a heap
blocks-of-a-heap-whose-sizes-do-not-fit = blocks of a heap whose sizes do not fit
powers-of-two = powers of two
kept-in-a-heap-in-a-way-that-is-not-read = kept in a heap in a way that is not read
byte-at-of-a-heap = byte { $at } of a heap
one-that-it-has = one that it has

## crates/measured/src/hdf5/layout.rs

an-array-s-size = an array's size
rank-dimensions = { $rank } dimensions
a-value-for-what-was-never-written = a value for what was never written
a-layout-of-class-class = a layout of class { $class }
t-0-1-or-2 = 0, 1 or 2
an-index-of-kind-kind = an index of kind { $kind }
t-1-to-5 = 1 to 5
parts-of-arrays-in-other-places-a-virtual-ar = parts of arrays in other places (a virtual array)
a-layout = a layout
chunks-of-rank-dimensions = chunks of { $rank } dimensions
rank-none-of-them-0 = { $rank }, none of them 0

## crates/measured/src/hdf5/links.rs

kind-0-below-level-most = kind 0, below level { $most }
a-link = a link

## crates/measured/src/hdf5/matlab.rs

structures-too-deep-in-each-other = structures too deep in each other
an-object-of-a-class = an object of a class
a-sparse-matrix = a sparse matrix
a-function-or-another-class = a function or another class
cells-that-are-no-references = cells that are no references
records-with-fields-of-different-lengths = records with fields of different lengths

## crates/measured/src/hdf5/tree.rs

groups-too-deep-in-each-other = groups too deep in each other
an-array-without-a-type = an array without a type

## crates/measured/src/layout/entries.rs

the-name-or-number-of-a-column-or-none = the name or number of a column, or none
a-number-above-0-at-most-most = a number above 0, at most { $most }
a-list-of-names-none-of-them-empty = a list of names, none of them empty
one-value-not-a-list = one value, not a list
a-layout-has-no-entry-key-did-you-mean-near = a layout has no entry `{ $key }`; did you mean `{ $near }`? There are { $list }
a-layout-has-no-entry-key-there-are-list = a layout has no entry `{ $key }`; there are { $list }

## crates/measured/src/layout/file.rs

version-must-be-version = `version` must be { $version }
a-list-of-texts = a list of texts

## crates/measured/src/matlab/element.rs

the-order-of-bytes-im-or-mi = the order of bytes, `IM` or `MI`
zlib-s-format = zlib's format
an-element-of-type-kind = an element of type { $kind }
a-variable-type-14-or-15 = a variable (type 14 or 15)
a-small-element-of-length-bytes = a small element of { $length } bytes
at-most-4 = at most 4
numbers-types-1-to-9-12-13 = numbers (types 1 to 9, 12, 13)
characters-types-1-2-4-16-17 = characters (types 1, 2, 4, 16, 17)
a-size-of-size = a size of { $size }
t-0-to-2147483647 = 0 to 2147483647
structures-more-than-depth-deep-in-each-othe = structures more than { $depth } deep in each other
an-array-of-size-values = an array of { $size } values
no-more-than-the-left-bytes-that-follow-hold = no more than the { $left } bytes that follow hold
count-values = { $count } values
a-value-type-14 = a value (type 14)
names-of-no-length = names of no length
t-1-to-64-characters = 1 to 64 characters

## crates/measured/src/parquet/mod.rs

a-file-without-columns = a file without columns
name-holds-no-numbers-and-was-left-out = `{ $name }` holds no numbers and was left out
an-end-without-par1 = an end without `PAR1`
a-file-that-was-written-to-its-end = a file that was written to its end
a-description-of-size-bytes = a description of { $size } bytes
a-tree-of-columns-that-does-not-fit = a tree of columns that does not fit
name-has-no-values = `{ $name }` has no values
some = some
pages-of-name-at-byte-byte = pages of `{ $name }` at byte { $byte }
a-page-without-its-size = a page without its size
a-page-of-count-values = a page of { $count } values

## crates/measured/src/parquet/pages.rs

a-page = a page
a-page-of-size-bytes = a page of { $size } bytes
the-compression-name-number-codec = the compression { $name } (number { $codec })
none-snappy-gzip-or-zstandard = none, Snappy, gzip or Zstandard
at-most-64 = at most 64
a-run-of-no-values = a run of no values
no-packed-numbers = no packed numbers
a-number-that-the-dictionary-does-not-have = a number that the dictionary does not have
below-count = below { $count }
the-encoding-encoding = the encoding { $encoding }
plain-dictionary-runs-differences-or-split-b = plain, dictionary, runs, differences or split bytes
count-values-in-parts-parts = { $count } values in { $parts } parts

## crates/measured/src/parquet/thrift.rs

a-number-of-more-than-64-bits = a number of more than 64 bits
a-value-of-type-kind = a value of type { $kind }
types-1-to-12 = types 1 to 12

## crates/measured/src/reader.rs

text-matlab-v5-or-v7-3-hdf5-tdms-or-parquet = text, MATLAB v5 or v7.3, HDF5, TDMS or Parquet
the-file-is-empty = the file is empty
it-is-the-index-of-a-tdms-file-give-the-file = it is the index of a TDMS file: give the file itself
key-means-nothing-for-a-file-of-the-format-f = `{ $key }` means nothing for a file of the format { $format }
the-file-has-no-column-with-numbers = the file has no column with numbers

## crates/measured/src/signal/align.rs

count-samples-to-align = { $count } samples to align
at-least-least = at least { $least }
two-series-that-nowhere-go-together = two series that nowhere go together
some-shift-at-which-one-rises-where-the-othe = some shift at which one rises where the other does

## crates/measured/src/signal/drift.rs

no-sample-from-from-to-to-s = no sample from { $from } to { $to } s
times-from-from-to-to-s = times from { $from } to { $to } s
a-sample-rate-rate-hz-in-the-layout = a sample rate: rate_hz in the layout
twice-the-time-time-s = twice the time { $time } s
two-times-apart = two times apart

## crates/measured/src/signal/low_pass.rs

a-cut-off-of-cut-off-hz = a cut-off of { $cut_off } Hz
above-0-and-below-most-hz = above 0 and below { $most } Hz

## crates/measured/src/signal/mod.rs

samples-that-are-not-even-in-time-or-whose-t = samples that are not even in time, or whose times are not known
no-samples = no samples

## crates/measured/src/signal/periods.rs

a-period-of-period-s = a period of { $period } s
above-0 = above 0
times-that-are-not-known-or-do-not-go-on = times that are not known, or do not go on
count-samples = { $count } samples
other-times-than-those-of-name = other times than those of `{ $name }`
the-same = the same

## crates/measured/src/signal/prepare.rs

drift-without-a-time-before-the-cut = drift without a time before the cut
two-times = two times
x-and-y = `{ $x }` and `{ $y }`
two-forces-of-one-length-and-an-angle = two forces of one length, and an angle
peaks-without-a-period = peaks without a period
a-period-in-s = a period in s
there-is-no-channel-name = there is no channel { $name }

## crates/measured/src/tdms/mod.rs

count-numbers = { $count } numbers
there-is-no-name-with-numbers = there is no { $name } with numbers
a-group-or-one-of-names = a group, or one of { $names }
name-has-the-scale-scale-which-is-not-applie = `{ $name }` has the scale { $scale }, which is not applied

## crates/measured/src/tdms/segments.rs

a-segment-which-begins-with-tdsm = a segment, which begins with `TDSm`
raw-data-bytes-bytes-behind = raw data { $bytes } bytes behind
no-length-of-raw-data-before-it = no length of raw data before it
raw-values-of-daqmx-which-are-scaled-elsewhe = raw values of DAQmx, which are scaled elsewhere
values-that-labview-has-converted-or-csv = values that LabVIEW has converted, or CSV
an-array-of-count-dimensions = an array of { $count } dimensions
values-of-type-kind = values of type { $kind }
numbers-texts-or-times = numbers, texts or times
fewer = fewer
numbers-of-16-bytes = numbers of 16 bytes
texts-between-numbers-value-by-value = texts between numbers, value by value
numbers-alone = numbers alone

## crates/measured/src/text/encoding.rs

byte-byte-is-no-utf-8 = byte { $byte } is no UTF-8
utf-8-or-another-encoding-latin-1 = UTF-8, or another encoding: latin-1
byte-byte-stands-in-no-text = byte { $byte } stands in no text
half-a-character-of-utf-16 = half a character of UTF-16
utf-16-or-another-encoding-utf-8-or-latin-1 = UTF-16, or another encoding: utf-8 or latin-1
a-whole-one = a whole one

## crates/measured/src/text/mod.rs

more-than-most-values = more than { $most } values
at-most-most-columns = at most { $most } columns
the-values-may-also-be-meant-with-separator = the values may also be meant with separator={ $separator } decimal={ $decimal }
line-line-breaks-off-and-was-left-out = line { $line } breaks off and was left out
lines-of-numbers-separated-by-tabs-semicolon = lines of numbers, separated by tabs, semicolons, commas or blanks
no-line-with-numbers-from-here-on-line = no line with numbers from here on: { $line }
the-text-ends-after-count-lines = the text ends after { $count } lines
key-is-line = `{ $key }` is { $line }
a-line-above-the-values-which-begin-in-line = a line above the values, which begin in line { $line }

## crates/measured/src/text/rows.rs

the-value-value = the value { $value }
no-more-than-count-values = no more than { $count } values
a-date-a-time-of-day-or-both = a date, a time of day, or both
a-number-with-a-decimal-point-or-nothing = a number with a decimal point, or nothing
a-number-with-a-decimal-comma-or-nothing = a number with a decimal comma, or nothing
number-thousands-parted-by-sign = { $number }, thousands parted by { $sign }
