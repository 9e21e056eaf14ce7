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

public enum KeyCode
{
    None = 0,
    Backspace = 8,
    Tab = 9,
    Return = 13,
    Escape = 27,
    Space = 32,
    Alpha0 = 48,
    Alpha1 = 49,
    Alpha2 = 50,
    Alpha3 = 51,
    A = 97,
    B = 98,
    C = 99,
    D = 100,
    L = 108,
    P = 112,
    R = 114,
    S = 115,
    T = 116,
    W = 119,
    UpArrow = 273,
    DownArrow = 274,
    RightArrow = 275,
    LeftArrow = 276,
    Mouse0 = 323,
    Mouse1 = 324,
    Mouse2 = 325,
}
