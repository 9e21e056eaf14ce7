namespace System.Runtime.CompilerServices;

// What the compiler calls for ranges of arrays. It takes the other member from here, too, once there is such a type.
internal static class RuntimeHelpers
{
    private static readonly Action<Array, RuntimeFieldHandle> Initialize = (Action<Array, RuntimeFieldHandle>)Delegate.CreateDelegate(
        typeof(Action<Array, RuntimeFieldHandle>),
        typeof(object).Assembly.GetType("System.Runtime.CompilerServices.RuntimeHelpers")!.GetMethod(nameof(InitializeArray))!);

    public static void InitializeArray(Array array, RuntimeFieldHandle field) => Initialize(array, field);

    public static T[] GetSubArray<T>(T[] array, Range range)
    {
        (int offset, int length) = range.GetOffsetAndLength(array.Length);
        return array.AsSpan(offset, length).ToArray();
    }
}
