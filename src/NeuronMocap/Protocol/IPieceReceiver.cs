namespace NeuronMocap.Protocol;

// A receiver that wants to know which packets arrive together. Small pieces are not announced.
internal interface IPieceReceiver : IPacketReceiver
{
    void BeginPiece();

    // Follows BeginPiece on the same thread, after the packets of the piece.
    void EndPiece();
}
