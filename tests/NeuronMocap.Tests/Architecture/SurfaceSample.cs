#pragma warning disable CA1051, CA1070, CA1716, CA1822, CA2225, CA1000, CA1720, CS0067, MA0095, MA0038, MA0018, CA1816, MA0055, CA1063, CA1721

namespace NeuronMocap.Tests.Architecture;

// One member of each kind, for the test of the surface text.
public abstract class SurfaceSample<T> : IDisposable
    where T : class, new()
{
    public const int Limit = 7;

    protected SurfaceSample()
    {
    }

    public event Action<string?>? Changed;

    public required string? Name { get; init; }

    public virtual int? State { get; protected set; }

    public double this[int index] => index;

    public static implicit operator int(SurfaceSample<T> value) => 0;

    public static bool Find(ReadOnlySpan<byte> bytes, out string? text, in int start, params object[] rest)
    {
        text = null;
        return false;
    }

    public void Dispose()
    {
    }

    public override string ToString() => "";

    internal void Hidden()
    {
    }

    protected abstract List<TItem[]?> Make<TItem>(T? item, DayOfWeek day = DayOfWeek.Friday, CancellationToken cancellationToken = default)
        where TItem : struct;
}
