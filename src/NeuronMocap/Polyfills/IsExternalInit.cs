namespace System.Runtime.CompilerServices;

// The compiler puts this type into the signature of every init accessor. All builds declare it, although .NET has its own. A library that was compiled
// against one build then finds the same signatures in the other.
internal static class IsExternalInit;
