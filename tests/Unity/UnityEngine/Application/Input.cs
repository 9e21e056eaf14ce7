namespace UnityEngine;

public static class Input
{
    private static readonly HashSet<KeyCode> _held = [];
    private static readonly HashSet<KeyCode> _pressed = [];
    private static readonly Dictionary<string, float> _axes = [];

    public static Vector3 mousePosition { get; internal set; }

    public static bool anyKeyDown => _pressed.Count > 0;

    public static bool GetKey(KeyCode key) => _held.Contains(key);

    public static bool GetKeyDown(KeyCode key) => _pressed.Contains(key);

    public static float GetAxis(string axisName) => _axes.TryGetValue(axisName, out float value) ? value : 0;

    public static bool GetMouseButton(int button) => _held.Contains(KeyCode.Mouse0 + button);

    internal static void Press(KeyCode key)
    {
        if (_held.Add(key))
            _pressed.Add(key);
    }

    internal static void Release(KeyCode key) => _held.Remove(key);

    internal static void SetAxis(string name, float value) => _axes[name] = value;

    internal static void EndFrame() => _pressed.Clear();

    internal static void Clear()
    {
        _held.Clear();
        _pressed.Clear();
        _axes.Clear();
    }
}
