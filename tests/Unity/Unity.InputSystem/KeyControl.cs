namespace UnityEngine.InputSystem.Controls;

public class KeyControl
{
    private int _frame = -1;

    public bool wasPressedThisFrame => Time.frameCount == _frame;

    /// <summary>Presses the key in the next frame.</summary>
    internal void Press() => _frame = Time.frameCount + 1;
}
