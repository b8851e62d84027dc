"""Writes the samples of HDF5 and MATLAB v7.3 beside it: pip install h5py hdf5storage tables."""
import os
import h5py, hdf5storage, numpy as np, tables

N = 40
t = np.arange(N) / 100.0
i = np.arange(N)
fx = 1.5 * i - 3          # exact in float32 and float64
fy = 0.25 * i * i
raw = (7 * i - 100).astype("int16")


def fresh(name):
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), name)
    if os.path.exists(path):
        os.remove(path)
    return path


# As h5py writes by default: superblock 0, groups by symbol tables, chunks by a B-tree.
with h5py.File(fresh("h5py.h5"), "w") as f:
    f.attrs["title"] = "cut 1"
    f.attrs["sample_rate"] = 100.0
    g = f.create_group("force")
    d = g.create_dataset("Fx", data=fx, chunks=(16,), compression="gzip", shuffle=True, fletcher32=True)
    d.attrs["units"] = "N"
    d = g.create_dataset("Fy", data=fy.astype(">f4"))
    d.attrs["unit"] = np.bytes_("kN")
    g.create_dataset("raw", data=raw.astype(">i2"))
    a = f.create_group("sensors/table")
    a.create_dataset("acc", data=np.stack([i, 2 * i, -i], axis=1).astype("int32"), chunks=(16, 2))
    f.create_dataset("empty", shape=(0,), dtype="f8")
    f.create_dataset("comment", data="free text")
    f["again"] = h5py.SoftLink("/force/Fx")

# The newest format: superblock 3, link messages, indexes of version 4.
with h5py.File(fresh("h5py_latest.h5"), "w", libver="latest") as f:
    f.create_dataset("time", data=t).attrs["units"] = "s"
    f.create_dataset("single", data=fx, chunks=(N,), compression="gzip").attrs["units"] = "N"
    f.create_dataset("fixed", data=fy, chunks=(7,))
    f.create_dataset("packed", data=raw, chunks=(7,), compression="gzip", shuffle=True)
    f.create_dataset("growing", data=fx - 1, chunks=(3,), maxshape=(None,))
    space = h5py.h5s.create_simple((N,))
    plist = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    plist.set_chunk((9,))
    plist.set_alloc_time(h5py.h5d.ALLOC_TIME_EARLY)
    one = h5py.h5d.create(f.id, b"implicit", h5py.h5t.IEEE_F64LE, space, plist)
    one.write(space, space, fy + 1)

# More links and attributes in a group than it keeps in its header; chunks that grow in both directions.
with h5py.File(fresh("h5py_dense.h5"), "w", libver="latest") as f:
    for n in range(12):
        f.create_dataset(f"c{n:02}", data=(i + n).astype("u1"))
    d = f["c03"]
    for n in range(12):
        d.attrs[f"note{n}"] = n
    d.attrs["units"] = "mm"
    f.create_dataset("grid", data=np.stack([i, 3 * i], axis=1).astype("i2"), chunks=(8, 2), maxshape=(None, None))

# Groups with times of their own, what attributes say, other kinds of numbers, and what is not read.
with h5py.File(fresh("h5py_groups.h5"), "w") as f:
    for cut in (1, 2):
        g = f.create_group(f"cut{cut}")
        g.create_dataset("time", data=1000 * t / cut).attrs["units"] = "ms"
        g.create_dataset("Fx", data=fx / cut).attrs["units"] = "N"
        g["up"] = f["/"]
    g = f.create_group("more")
    g.attrs["fs"] = 50
    d = g.create_dataset("matrix", data=np.stack([i, -i], axis=1).astype("f2"))
    d.attrs["columns"], d.attrs["units"] = ["ax", "ay"], ["g", "m/s2"]
    d = g.create_dataset("packed", data=raw, chunks=(20,), compression="lzf")
    d.attrs["scale_factor"], d.attrs["add_offset"] = 0.5, 10.0
    g.create_dataset("flags", data=i % 3 == 0)
    d = g.create_dataset("holes", shape=(N,), dtype=">u8", chunks=(10,), fillvalue=7)
    d[10:20] = i[10:20]
    g.create_dataset("complex", data=fx + 1j)
    g.create_dataset("whole", data=i, chunks=(N,), scaleoffset=0)
    g.create_dataset("endless", shape=(1 << 50,), dtype="f8", chunks=(100,))

# A table of PyTables: compound records, compressed by deflate.
with tables.open_file(fresh("pytables.h5"), "w") as f:
    class Row(tables.IsDescription):
        time = tables.Float64Col(pos=0)
        Fx = tables.Float32Col(pos=1)
        count = tables.Int16Col(pos=2)
        label = tables.StringCol(4, pos=3)
        axes = tables.Float32Col(shape=(2,), pos=4)
    table = f.create_table("/", "cut", Row, filters=tables.Filters(complevel=5, complib="zlib"), chunkshape=(16,))
    for n in range(N):
        r = table.row
        r["time"], r["Fx"], r["count"], r["label"], r["axes"] = t[n], fx[n], raw[n], "a", (n, -n)
        r.append()

# MATLAB v7.3: a struct with one within, an array of structs, cells, texts.
mat = {
    "data": {"Fx": fx, "Fy": fy, "fs": 100.0, "unit": "N", "inner": {"T": np.stack([i, i + 0.5], axis=1)}},
    "names": np.array(["first", "second"], dtype=object),
}
hdf5storage.savemat(fresh("hdf5storage.mat"), mat, format="7.3", matlab_compatible=True, store_python_metadata=False)
mill = np.zeros((1, 2), dtype=[("run", "f8"), ("VB", "f8"), ("smcAC", "O")])
for n in range(2):
    mill[0, n] = (n + 1, 0.1 * n, (fx + n).reshape(-1, 1))
hdf5storage.savemat(fresh("hdf5storage_records.mat"), {"mill": mill}, format="7.3", matlab_compatible=True, store_python_metadata=False)
