using NeuronMocap.Unity.Tests.Drivers;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public sealed class HandPropMenuTests : IDisposable
{
    private readonly EditorWorld _world = new();

    public void Dispose() => _world.Dispose();

    [Fact]
    public void Holding_a_prop_as_placed_can_be_undone()
    {
        HandProp prop = new GameObject("Sword").AddComponent<HandProp>();
        prop.Driver = TestFigure.Build("Figure").Drive(null);
        prop.SendMessage("HoldAsPlacedFromMenu");
        Assert.NotEqual(default, prop.PositionOffset);
        Assert.NotEqual(default, prop.RotationOffset);

        Undo.PerformUndo();
        Assert.Equal((default, default), (prop.PositionOffset, prop.RotationOffset));
        Assert.Empty(ConsoleLog.Entries);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_prop_that_nothing_holds_says_so(bool hasDriver)
    {
        Undo.ClearAll();
        HandProp prop = new GameObject("Sword").AddComponent<HandProp>();
        prop.Driver = hasDriver ? new GameObject("Figure").AddComponent<HumanoidDriver>() : null;

        prop.SendMessage("HoldAsPlacedFromMenu");

        LogEntry entry = Assert.Single(ConsoleLog.Entries);
        Assert.Equal((LogType.Warning, (UnityEngine.Object?)prop), (entry.Type, entry.Context));
        Assert.Contains(hasDriver ? "bone" : "Driver", entry.Message, StringComparison.Ordinal);
        Assert.Empty(Undo.Names);
    }
}
