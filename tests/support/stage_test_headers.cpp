// Only its precompiled headers are wanted.
int main() {}
