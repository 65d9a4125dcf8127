"""Many runs at once: each in a process of its own with one BLAS thread, results in the order of the cases."""

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import get_context
from typing import TypeVar

Case = TypeVar("Case")
Result = TypeVar("Result")

BLAS_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")


def usable_cores() -> int:
    """How many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def one_blas_thread() -> Iterator[None]:
    """Processes started inside use one thread each: many would only get into each other's way, and could round differently."""
    before = {name: os.environ.get(name) for name in BLAS_THREADS}
    os.environ.update(dict.fromkeys(BLAS_THREADS, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            os.environ.pop(name, None)
            if value is not None:
                os.environ[name] = value


def run_all(
    work: Callable[[Case], Result],
    cases: Sequence[Case],
    jobs: int,
    lost: Callable[[Case], Result],
    done: Callable[[int], None] = lambda count: None,
) -> list[Result]:
    """`work` of every case, at most `jobs` at a time; equal results whatever `jobs` is, if `work` depends on its case alone.

    lost: the result of a case that no process could finish (one that dies takes the unfinished ones along);
    done: called with the number of finished cases after each.
    """
    results: dict[int, Result] = {}
    with one_blas_thread():
        pool = ProcessPoolExecutor(max(1, min(jobs, len(cases))), mp_context=get_context("spawn"))
        try:
            places = {pool.submit(work, case): place for place, case in enumerate(cases)}
            for future in as_completed(places):
                try:
                    results[places[future]] = future.result()
                except BrokenProcessPool:
                    continue
                done(len(results))
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
    return [results[place] if place in results else lost(case) for place, case in enumerate(cases)]
