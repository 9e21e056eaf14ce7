namespace NeuronMocap.Server;

/// <summary>
/// Computes the values of a calculation packet: 59 bones in the order of the calculation stream and the two contact flags (protocol.md
/// section 3.3). A pure function of the frame number, called on several threads at once.
/// </summary>
/// <param name="source">The avatar's performance, with the turns of <see cref="Broadcaster.ZeroOut"/>: an object of another class than the option's once it is turned.</param>
/// <param name="frame">Frame number, from 0, below the source's count.</param>
/// <param name="values">Room for exactly 946 values, all of which are written: metres, metres per second and the sensors' units.</param>
public delegate void CalculationWriter(MotionSource source, long frame, Span<float> values);
