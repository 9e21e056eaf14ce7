using NeuronMocap.Tests.Architecture.Samples.High;

#pragma warning disable CA1812, CA1822, CA1852, CA1823, CS0169, CS0067, IDE0051, IDE0059, CS0219, CA1051, CS0649, CA1802

namespace NeuronMocap.Tests.Architecture.Samples.Low;

internal sealed class Innocent
{
    public static void Fail() => throw new RootError();
}

internal sealed class OfRoot
{
    public static void Use() => RootHelper.Help();
}

internal sealed class AsBase : Fruit;

internal sealed class AsField
{
    private readonly Fruit? _fruit;
}

internal sealed class AsArray
{
    private readonly Fruit[][]? _fruits;
}

internal sealed class AsGenericArgument
{
    private readonly Dictionary<int, List<Fruit>>? _fruits;
}

internal sealed class AsProperty
{
    public static Fruit? Value => null;
}

internal sealed class AsEvent
{
    public event Action<Fruit>? Changed;
}

internal sealed class AsParameter
{
    public static void Use(ref Fruit fruit)
    {
    }
}

internal sealed class AsResult
{
    public static Fruit? Use() => null;
}

internal sealed class AsConstraint<T>
    where T : Fruit;

[Fruit]
internal sealed class AsAttribute;

internal sealed class AsCall
{
    public static void Use() => Fruit.Count++;
}

internal sealed class AsArgument
{
    public static void Use() => GC.KeepAlive(Array.Empty<Fruit>());
}

internal sealed class AsLocal
{
    public static void Use()
    {
        Fruit[] fruits = [];
        GC.KeepAlive(fruits);
    }
}

internal sealed class AsTypeOf
{
    public static string Use() => typeof(Fruit).Name;
}

internal sealed class AsLambda
{
    public static Func<int> Use(int more) => () => Fruit.Count + more;
}

internal sealed class AsNested
{
    internal sealed class Inner
    {
        private readonly Fruit? _fruit;
    }
}
