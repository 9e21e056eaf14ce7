namespace System.Runtime.CompilerServices;

// The compiler marks init accessors with this type; netstandard2.1 does not carry it.
internal static class IsExternalInit;
