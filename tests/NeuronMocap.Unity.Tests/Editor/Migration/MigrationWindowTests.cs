using NeuronMocap.Unity.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor.Migration;

public sealed class MigrationWindowTests : IDisposable
{
    private readonly VendorProject _project = new(hasScripts: true);
    private MigrationWindow? _window;

    public void Dispose()
    {
        if (_window is { } window)
            window.Close();

        _project.Dispose();
    }

    [Fact]
    public void The_menu_lists_first_and_a_button_converts()
    {
        NeuronAnimatorInstance instance = new GameObject("Figure").AddComponent<NeuronAnimatorInstance>();
        new GameObject("Manager").AddComponent<NeuronInstancesManager>();
        Action draw = Open();
        ImmediateGui.Draw(draw);
        Assert.Contains("1 component can be converted, 1 component cannot.", EditorWorld.Labels("Label"));
        Assert.Contains("Figure: NeuronAnimatorInstance", EditorWorld.Labels("Label"));
        Assert.Contains("commit or copy the project first", Assert.Single(EditorWorld.Labels("HelpBox")), StringComparison.Ordinal);
        Assert.True(instance != null);

        ImmediateGui.Click(draw, MigrationWindow.Convert);
        ImmediateGui.Draw(draw);

        Assert.True(instance == null);
        Assert.Contains("1 component converted, 1 component left.", EditorWorld.Labels("Label"));
        Assert.False(EditorWorld.Find(MigrationWindow.Convert).IsEnabled);
        Assert.Contains("Performer Spawner", Assert.Single(ConsoleLog.Entries).Message, StringComparison.Ordinal);
        ImmediateGui.Click(draw, MigrationWindow.SearchAgain);
        Assert.False(Assert.Single(_window!.Items).IsConvertible);
    }

    [Fact]
    public void Nothing_to_convert_is_said()
    {
        ImmediateGui.Draw(Open());

        Assert.Contains("The project has no vendor components.", EditorWorld.Labels("Label"));
        Assert.False(EditorWorld.Find(MigrationWindow.Convert).IsEnabled);
    }

    [Fact]
    public void Play_mode_has_no_conversion()
    {
        Action draw = Open();
        _project.World.Loop.EnterPlayMode();
        ImmediateGui.Draw(draw);

        Assert.False(EditorWorld.Find(MigrationWindow.SearchAgain).IsEnabled);
        Assert.False(MenuItems.Execute(MigrationWindow.Menu));
        _project.World.Loop.ExitPlayMode();
    }

    private Action Open()
    {
        Assert.True(MenuItems.Execute(MigrationWindow.Menu));
        _window = EditorWindow.GetWindow<MigrationWindow>();
        return (Action)Delegate.CreateDelegate(typeof(Action), _window, "OnGUI");
    }
}
