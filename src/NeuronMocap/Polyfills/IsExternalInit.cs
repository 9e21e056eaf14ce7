namespace System.Runtime.CompilerServices;

// The compiler puts this type into the signature of every init accessor. Both builds declare it, although .NET has its own: a library that was compiled
// on one build then finds the same signatures in the other.
internal static class IsExternalInit;
