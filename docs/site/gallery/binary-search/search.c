/* The place of the first entry of a sorted array that is not less than the key. */
size_t find(const int *a, size_t n, int key)
{
    size_t lo = 0, hi = n; /* invariant: 0 <= lo <= hi <= n */
    while (lo < hi) {
        size_t mid = lo + (hi - lo) / 2;
        if (a[mid] < key)
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}
