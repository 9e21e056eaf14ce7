namespace NeuronMocap.Recording;

// The next action of a playback.
internal enum PlaybackAction
{
    Play,
    Step,
    StepBack,
    Seek,
    Stop,
}
