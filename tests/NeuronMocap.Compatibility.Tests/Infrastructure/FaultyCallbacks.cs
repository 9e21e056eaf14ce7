using System.Diagnostics.CodeAnalysis;
using System.Reflection;
using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Tests.Infrastructure;

/// <summary>Callbacks with one member that always throws.</summary>
[SuppressMessage("Performance", "CA1852", Justification = "The proxy derives from it.")]
internal class FaultyCallbacks : DispatchProxy
{
    private string _member = "";
    private int _calls;

    public int Calls => Volatile.Read(ref _calls);

    public static IVendorCallbacks Of(string member)
    {
        IVendorCallbacks callbacks = Create<IVendorCallbacks, FaultyCallbacks>();
        ((FaultyCallbacks)callbacks)._member = member;
        return callbacks;
    }

    protected override object? Invoke(MethodInfo? targetMethod, object?[]? args)
    {
        if (targetMethod!.Name == _member)
        {
            Interlocked.Increment(ref _calls);
            throw new InvalidOperationException("As meant.");
        }

        return targetMethod.ReturnType == typeof(bool) ? true
            : targetMethod.ReturnType.IsEnum ? Enum.ToObject(targetMethod.ReturnType, 0)
            : null;
    }
}
