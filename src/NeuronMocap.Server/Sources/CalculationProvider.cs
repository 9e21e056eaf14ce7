namespace NeuronMocap.Server;

/// <summary>
/// Computes the values of a calculation packet: 59 bones in the order of the calculation stream, and the two contact flags (protocol.md
/// section 3.3).
/// </summary>
/// <remarks>A provider must be a pure function of the frame number. It is called on several threads at once.</remarks>
/// <param name="source">
/// The source of the avatar, including the turns of <see cref="Broadcaster.ZeroOut"/>. After such a turn, its class differs from that of the source
/// in the options.
/// </param>
/// <param name="frame">Frame number, from 0, below the frame count of the source.</param>
/// <param name="values">
/// Room for exactly 946 values. The provider writes all of them, in metres, metres per second and the units of the sensors.
/// </param>
public delegate void CalculationProvider(MotionSource source, long frame, Span<float> values);
