using NUnit.Framework;

namespace UnityEngine.TestTools;

/// <summary>A test that continues in later frames. It returns an IEnumerator.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class UnityTestAttribute : CombiningStrategyAttribute, NUnit.Framework.Interfaces.IImplyFixture
{
    public UnityTestAttribute()
        : base(new NUnit.Framework.Internal.Builders.CombinatorialStrategy(), new NUnit.Framework.Internal.Builders.ParameterDataSourceProvider())
    {
    }
}

[AttributeUsage(AttributeTargets.Method)]
public sealed class UnitySetUpAttribute : NUnitAttribute
{
}

[AttributeUsage(AttributeTargets.Method)]
public sealed class UnityTearDownAttribute : NUnitAttribute
{
}
