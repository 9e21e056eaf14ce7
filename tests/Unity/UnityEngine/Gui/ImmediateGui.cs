namespace UnityEngine.StandIn;

/// <summary>
/// Runs immediate-mode code as the editor does: a layout pass, then the event. Keeps the controls of the event's pass, and clicks or changes one
/// control by its label. As in Unity, it is an error if the controls of a pass differ from those of its layout. Main thread.
/// </summary>
internal static class ImmediateGui
{
    private static readonly List<string> _layout = [];
    private static string? _wanted;
    private static object? _newValue;
    private static bool _isDone;
    private static int _row;
    private static int _rowDepth;

    /// <summary>The controls of the last pass.</summary>
    public static List<GuiControl> Controls { get; } = [];

    /// <summary>The lines of the last pass.</summary>
    public static List<GuiLine> Lines { get; } = [];

    /// <summary>The result of GUILayoutUtility.GetRect.</summary>
    public static Rect FreeRect { get; set; } = new(0, 200, 400, 300);

    internal static Stack<Rect> Clips { get; } = new();

    /// <summary>Runs layout and repaint.</summary>
    public static void Draw(Action onGui) => Run(onGui, new Event { type = EventType.Repaint });

    /// <summary>Runs layout and an event of the mouse or the keyboard.</summary>
    public static void Send(Action onGui, Event sent) => Run(onGui, sent);

    /// <summary>Clicks the button, or toggles the control, with the label. It must exist once and be enabled.</summary>
    public static void Click(Action onGui, string label) => Change(onGui, label, null);

    /// <summary>Sets the field with the label to a value, as if typed.</summary>
    public static void Set(Action onGui, string label, object value) => Change(onGui, label, value);

    /// <summary>Records a control, for GUILayout and EditorGUILayout.</summary>
    public static void Add(string kind, string label, string value = "", Color? color = null, string tooltip = "", bool isEnabled = true)
    {
        if (_rowDepth == 0)
            _row++;

        Controls.Add(new GuiControl(kind, label, value, GUI.enabled && isEnabled, color, _row, tooltip));
    }

    /// <summary>Records a button. Returns true if it is clicked.</summary>
    public static bool Button(string kind, string label)
    {
        Add(kind, label);
        return IsWanted(label);
    }

    /// <summary>Records a toggle. Returns its new value.</summary>
    public static bool Toggle(bool value, string label)
    {
        Add("Toggle", label, value ? "on" : "off");
        return IsWanted(label) ? !value : value;
    }

    /// <summary>Returns whether the test has a new value for the field that was just added.</summary>
    public static bool TryTake(string label, out object? value)
    {
        value = _newValue;
        return _newValue is not null && IsWanted(label);
    }

    /// <summary>For UnityEditor's Handles: in the window's pixels, regardless of clipping.</summary>
    public static void AddLine(Vector2 from, Vector2 to, Color color, float width)
    {
        Vector2 origin = Clips.Count > 0 ? new Vector2(Clips.Peek().x, Clips.Peek().y) : Vector2.zero;
        Lines.Add(new GuiLine(from + origin, to + origin, color, width));
    }

    /// <summary>Starts a row. Controls added until the row ends are in one row.</summary>
    public static void BeginRow()
    {
        if (_rowDepth++ == 0)
            _row++;
    }

    /// <summary>Ends a row.</summary>
    public static void EndRow() => _rowDepth--;

    private static void Change(Action onGui, string label, object? value)
    {
        (_wanted, _newValue, _isDone) = (label, value, false);
        try
        {
            Run(onGui, new Event { type = EventType.MouseUp });
            if (!_isDone)
                throw new InvalidOperationException($"There is no enabled '{label}'. There are:\n{string.Join("\n", Controls)}");
        }
        finally
        {
            (_wanted, _newValue) = (null, null);
        }
    }

    private static bool IsWanted(string label)
    {
        if (_wanted != label || Event.current.type == EventType.Layout || !GUI.enabled || _isDone)
            return false;

        _isDone = true;
        GUI.changed = true;
        Event.current.Use();
        return true;
    }

    private static void Run(Action onGui, Event sent)
    {
        RunPass(onGui, new Event { type = EventType.Layout, mousePosition = sent.mousePosition });
        _layout.Clear();
        _layout.AddRange(Controls.Select(static control => control.Kind));
        RunPass(onGui, sent);

        // A click may change the controls after it. Unity then also ends the pass differently.
        if (_wanted is null && !_layout.SequenceEqual(Controls.Select(static control => control.Kind)))
            throw new InvalidOperationException($"The controls of {sent.type} are not those of the layout pass: {_layout.Count} were laid out, {Controls.Count} drawn.");
    }

    private static void RunPass(Action onGui, Event pass)
    {
        Controls.Clear();
        Lines.Clear();
        (_row, _rowDepth) = (0, 0);
        GUI.enabled = true;
        Event before = Event.current;
        Event.current = pass;
        try
        {
            onGui();
        }
        finally
        {
            Event.current = before;
        }

        if (_rowDepth != 0 || Clips.Count != 0)
            throw new InvalidOperationException("A row or a clip was started but not ended.");
    }
}
