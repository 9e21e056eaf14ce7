using NeuronMocap.Tests.Architecture.Samples.Low;

namespace NeuronMocap.Tests.Architecture.Samples.High;

// A forbidden type, and one use in the allowed direction.
internal class Fruit
{
    public static int Count { get; set; }

    public static Innocent UseOfALowerFolder() => new();
}

[AttributeUsage(AttributeTargets.Class)]
internal sealed class FruitAttribute : Attribute;
