namespace NeuronMocap.Recording;

// What the playback does next.
internal enum PlaybackAction
{
    Play,
    Step,
    StepBack,
    Seek,
    Stop,
}
