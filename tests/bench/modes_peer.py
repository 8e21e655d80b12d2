"""The peer of tests/bench/modes.mjs: SciPy's eigsh in shift-invert mode, its inverse from CHOLMOD's supernodal factor.

Usage: modes_peer.py MATRIX [--modes 12] [--count-nonzeros]      prints JSON
Needs numpy, scipy and scikit-sparse (which needs SuiteSparse, e.g. apt install libsuitesparse-dev). MATRIX is what
tests/bench/native/shell_modes.cpp exports: K and M as our solver has them, and its shift. CHOLMOD's supernodal part is
GPL: it is measured here and is no part of what ships.
"""

import argparse
import json
import time

import numpy as np
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import LinearOperator, eigsh
from sksparse.cholmod import analyze

ZERO_MODES = 6


def read_matrix(path):
    """K, the diagonal of M, the shift."""
    with open(path, "rb") as file:
        size, entries = np.fromfile(file, np.uint32, 2)
        shift = np.fromfile(file, np.float64, 1)[0]
        column_start = np.fromfile(file, np.int32, size + 1)
        row = np.fromfile(file, np.int32, entries)
        value = np.fromfile(file, np.float64, entries)
        mass = np.fromfile(file, np.float64, size)
    column = np.repeat(np.arange(size, dtype=np.int32), np.diff(column_start))
    below = row != column
    rows = np.concatenate((row, column[below]))
    columns = np.concatenate((column, row[below]))
    values = np.concatenate((value, value[below]))
    # Through triplets: a sum of sparse matrices would drop the entries that are 0.
    return csc_matrix((values, (rows, columns)), shape=(size, size)), mass, shift


def shifted_matrix(stiffness, mass, shift):
    shifted = stiffness.copy()
    shifted.setdiag(stiffness.diagonal() - shift * mass)
    return shifted


def solve(stiffness, mass, shift, mode_count):
    """Everything from K and M to eigenpairs, timed in parts. M is singular, so the search runs on the symmetric form
    M^1/2 (K - shift M)^-1 M^1/2 over the unknowns with mass, as ours does."""
    start = time.perf_counter()
    shifted = shifted_matrix(stiffness, mass, shift)
    factor = analyze(shifted, mode="supernodal", ordering_method="metis")
    analysed = time.perf_counter()
    factor.cholesky_inplace(shifted)
    factorised = time.perf_counter()
    heavy = np.flatnonzero(mass > 0)
    root = np.sqrt(mass[heavy])
    calls = 0

    def inverse(x):
        nonlocal calls
        calls += 1
        full = np.zeros(len(mass))
        full[heavy] = root * x.ravel()
        return root * factor(full)[heavy]

    operator = LinearOperator((len(heavy), len(heavy)), matvec=inverse, dtype=np.float64)
    count = mode_count + ZERO_MODES
    nu = eigsh(operator, k=count, which="LA", tol=1e-10, return_eigenvectors=True)[0]
    end = time.perf_counter()
    values = np.sort(1 / nu + shift)
    return {
        "seconds": end - start,
        "analyse": analysed - start,
        "factorise": factorised - analysed,
        "search": end - factorised,
        "solves": calls,
        "firstLambda": values[ZERO_MODES],
    }


def count_nonzeros(stiffness, mass, shift):
    """Nonzeros of L for CHOLMOD's order by METIS, and for its own nested dissection (which uses METIS and CAMD)."""
    shifted = shifted_matrix(stiffness, mass, shift)
    counts = {}
    for ordering in ("metis", "nesdis"):
        factor = analyze(shifted, mode="simplicial", ordering_method=ordering)
        factor.cholesky_inplace(shifted)
        counts[ordering] = int(factor.L().nnz)
    return counts


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("matrix")
    parser.add_argument("--modes", type=int, default=12)
    parser.add_argument("--count-nonzeros", action="store_true")
    options = parser.parse_args()
    stiffness, mass, shift = read_matrix(options.matrix)
    result = {} if options.count_nonzeros else solve(stiffness, mass, shift, options.modes)
    if options.count_nonzeros:
        result["nonzeros"] = count_nonzeros(stiffness, mass, shift)
    print(json.dumps(result))


main()
