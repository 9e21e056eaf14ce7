namespace NeuronMocap.Server;

/// <summary>
/// Computes the payload of Axis Studio's calculation packet: 59 bones of 84 bytes in <see cref="Bone"/> order (protocol.md section 9).
/// </summary>
/// <remarks>A provider must be a pure function of the frame number. It is called on several threads at once.</remarks>
/// <param name="source">The source of the avatar.</param>
/// <param name="frame">Frame number, from 0, below the frame count of the source.</param>
/// <param name="payload">Room for exactly 4956 bytes. The provider writes all of them, little-endian.</param>
public delegate void StudioCalculationProvider(MotionSource source, long frame, Span<byte> payload);
