using System.ComponentModel;
using System.Runtime.ExceptionServices;

namespace NeuronMocap;

/// <summary>An avatar of an <see cref="ObservableReader"/>. Its properties change on the window's thread.</summary>
public sealed class ObservableAvatar : INotifyPropertyChanged
{
    private static readonly PropertyChangedEventArgs NameChanged = new(nameof(Name));
    private static readonly PropertyChangedEventArgs FrameRateChanged = new(nameof(FrameRate));
    private static readonly PropertyChangedEventArgs CalculationRateChanged = new(nameof(CalculationRate));
    private static readonly PropertyChangedEventArgs FramesChanged = new(nameof(Frames));
    private static readonly PropertyChangedEventArgs LostChanged = new(nameof(Lost));

    private string _name = string.Empty;
    private double _frameRate;
    private double _calculationRate;
    private long _frames;
    private long _lost;

    internal ObservableAvatar(int sender, int avatarIndex)
    {
        Sender = sender;
        AvatarIndex = avatarIndex;
    }

    /// <summary>Occurs on the context after a property has changed.</summary>
    public event PropertyChangedEventHandler? PropertyChanged;

    /// <summary>Number of the sender: see <see cref="AvatarFrame.Sender"/>.</summary>
    public int Sender { get; }

    /// <summary>Number of the avatar on the server.</summary>
    public int AvatarIndex { get; }

    /// <summary>Name of the avatar in its newest frame.</summary>
    public string Name => _name;

    /// <summary>Motion frames per second, rounded to a tenth: a running mean, or 0 if none arrived for a second.</summary>
    public double FrameRate => _frameRate;

    /// <summary>Calculation frames per second, in the same way.</summary>
    public double CalculationRate => _calculationRate;

    /// <summary>Number of frames received, of all kinds.</summary>
    public long Frames => _frames;

    /// <summary>Number of frames that the server sent but that did not arrive: see <see cref="AvatarStatistics.Lost"/>.</summary>
    public long Lost => _lost;

    // failure: takes the first exception of a handler.
    internal void Update(in AvatarTotals totals, ref ExceptionDispatchInfo? failure)
    {
        Set(ref _name, totals.Name, NameChanged, ref failure);
        Set(ref _frameRate, Math.Round(totals.FrameRate, 1), FrameRateChanged, ref failure);
        Set(ref _calculationRate, Math.Round(totals.CalculationRate, 1), CalculationRateChanged, ref failure);
        Set(ref _frames, totals.Frames, FramesChanged, ref failure);
        Set(ref _lost, totals.Lost, LostChanged, ref failure);
    }

    private void Set<T>(ref T field, T value, PropertyChangedEventArgs changed, ref ExceptionDispatchInfo? failure)
    {
        if (PropertyChange.TrySet(ref field, value))
            PropertyChange.Raise(PropertyChanged, this, changed, ref failure);
    }
}
