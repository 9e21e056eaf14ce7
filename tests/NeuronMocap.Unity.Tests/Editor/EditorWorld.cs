using NeuronMocap.Diagnostics;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.Tests.Editor;

// An editor with an empty scene and an empty project.
internal sealed class EditorWorld : IDisposable
{
    private readonly List<UnityEditor.Editor> _inspectors = [];

    public EditorWorld(bool play = false)
    {
        Loop = new PlayerLoop(play);
        Undo.ClearAll();
        Selection.objects = [];
        DiagnosisPanel.Options = new DiagnosisOptions { Timeout = TimeSpan.FromSeconds(1), SearchOtherPorts = false };
    }

    public PlayerLoop Loop { get; }

    public static IReadOnlyList<GuiControl> Controls => ImmediateGui.Controls;

    // The labels of one kind in the last pass.
    public static IEnumerable<string> Labels(string kind) => Controls.Where(control => control.Kind.Equals(kind, StringComparison.Ordinal)).Select(static control => control.Label);

    public static GuiControl Find(string label) => Controls.First(control => control.Label.Contains(label, StringComparison.Ordinal));

    // The colour of the dot in the row of a headline.
    public static Color? DotOf(string headline) => Controls.First(control => control.Row == Find(headline).Row).Color;

    // Beside the active scene, and empty.
    public static Scene AddScene(string name)
    {
        SceneManager.Others.Add(name);
        return SceneManager.GetSceneAt(SceneManager.sceneCount - 1);
    }

    public MocapSource AddSource(Action<MocapSource> set, string name = "Source")
    {
        var holder = new GameObject(name);
        holder.SetActive(false);
        MocapSource source = holder.AddComponent<MocapSource>();
        set(source);
        holder.SetActive(true);
        return source;
    }

    public UnityEditor.Editor Inspect(params Object[] targets)
    {
        var inspector = UnityEditor.Editor.CreateEditor(targets);
        _inspectors.Add(inspector);
        return inspector;
    }

    // A test that waited may continue on another thread.
    public void Dispose()
    {
        MainThread.Claim();
        foreach (UnityEditor.Editor inspector in _inspectors)
            Object.DestroyImmediate(inspector);

        DiagnosisPanel.Options = null;
        Loop.Dispose();
    }
}
