using NeuronMocap.Unity.EditorTools;
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

    [Fact]
    public void A_body_that_is_not_kinematic_is_reported_and_changed_by_a_click()
    {
        HandProp prop = new GameObject("Sword").AddComponent<HandProp>();
        UnityEditor.Editor inspector = _world.Inspect(prop);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.DoesNotContain("HelpBox", EditorWorld.Controls.Select(static control => control.Kind));

        Rigidbody body = prop.gameObject.AddComponent<Rigidbody>();
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.Equal(("HelpBox", "Warning"), (EditorWorld.Find("not kinematic").Kind, EditorWorld.Find("not kinematic").Value));
        ImmediateGui.Click(inspector.OnInspectorGUI, PhysicsCheck.MakeKinematic);
        Assert.True(body.isKinematic);
        ImmediateGui.Draw(inspector.OnInspectorGUI);
        Assert.DoesNotContain("HelpBox", EditorWorld.Controls.Select(static control => control.Kind));

        Undo.PerformUndo();
        Assert.False(body.isKinematic);
    }
}
