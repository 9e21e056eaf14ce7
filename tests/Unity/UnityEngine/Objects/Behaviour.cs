namespace UnityEngine;

public class Behaviour : Component
{
    private bool _enabled = true;

    public bool enabled
    {
        get
        {
            Check();
            return _enabled;
        }

        set
        {
            Check();
            if (_enabled == value)
                return;

            _enabled = value;
            RefreshActivity();
        }
    }

    public bool isActiveAndEnabled
    {
        get
        {
            Check();
            return IsRunning;
        }
    }

    internal bool IsRunning => _enabled && !IsDestroyed && Owner is { } owner && owner.IsActive;

    internal virtual void RefreshActivity()
    {
    }
}
