using System.ComponentModel;

namespace NeuronMocap;

/// <summary>An object whose properties a window can bind to. They change on the window's thread.</summary>
public abstract class ObservableObject : INotifyPropertyChanged
{
    private protected ObservableObject()
    {
    }

    /// <summary>Occurs on the context after a property has changed.</summary>
    public event PropertyChangedEventHandler? PropertyChanged;

    // The arguments are made once for each property, so an update allocates nothing for them.
    private protected void Set<T>(ref T field, T value, PropertyChangedEventArgs changed)
    {
        if (EqualityComparer<T>.Default.Equals(field, value))
            return;

        field = value;
        PropertyChanged?.Invoke(this, changed);
    }
}
