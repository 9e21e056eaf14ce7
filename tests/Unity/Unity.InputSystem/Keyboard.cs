using UnityEngine.InputSystem.Controls;

namespace UnityEngine.InputSystem;

/// <summary>Without a keyboard, <see cref="current"/> is null, as on a device that has none.</summary>
public class Keyboard
{
    private readonly KeyControl[] _keys = Enumerable.Range(0, (int)Key.Last + 1).Select(static _ => new KeyControl()).ToArray();

    public static Keyboard? current { get; internal set; }

    public KeyControl this[Key key] => key > Key.None && key <= Key.Last ? _keys[(int)key] : throw new ArgumentOutOfRangeException(nameof(key));

    internal void Press(Key key) => this[key].Press();
}
