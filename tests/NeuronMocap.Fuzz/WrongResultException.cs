using System.Globalization;

namespace NeuronMocap.Fuzz;

/// <summary>A parser returned a wrong answer.</summary>
internal sealed class WrongResultException(string message) : Exception(message)
{
    public static void ThrowUnless(bool condition, string message)
    {
        if (!condition)
            throw new WrongResultException(message);
    }

    // Formats the text only when it is needed, because the allocations of a target are measured.
    public static void ThrowUnless<T>(bool condition, string format, T value) => ThrowUnless(condition, format, value, 0, 0);

    public static void ThrowUnless<T1, T2>(bool condition, string format, T1 first, T2 second) => ThrowUnless(condition, format, first, second, 0);

    public static void ThrowUnless<T1, T2, T3>(bool condition, string format, T1 first, T2 second, T3 third)
    {
        if (!condition)
            throw new WrongResultException(string.Format(CultureInfo.InvariantCulture, format, first, second, third));
    }
}
