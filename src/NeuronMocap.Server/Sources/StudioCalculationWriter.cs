namespace NeuronMocap.Server;

/// <summary>
/// Computes the bytes behind the header of Axis Studio's calculation packet: 59 bones of 84 bytes in <see cref="Bone"/> order
/// (protocol.md section 9). A pure function of the frame number, called on several threads at once.
/// </summary>
/// <param name="source">The avatar's performance.</param>
/// <param name="frame">Frame number, from 0, below the source's count.</param>
/// <param name="payload">Room for exactly 4956 bytes, all of which are written; little-endian.</param>
public delegate void StudioCalculationWriter(MotionSource source, long frame, Span<byte> payload);
