using System.Text;

namespace NeuronMocap.Tests.Commands;

// Replies as described in protocol.md section 7, written by hand. By default, the length field is 64 plus the payload.
internal static class DataReplies
{
    public static byte[] AvatarCount(int count) => Make(5, dataCount: 0, count, 0, []);

    public static byte[] Frequency(int avatar, int frequency) => Make(3, dataCount: 0, avatar, frequency, []);

    public static byte[] CombinationMode(int avatar, int mode) => Make(6, dataCount: 0, avatar, mode, []);

    public static byte[] BvhText(string text) => Make(4, dataCount: text.Length, 0, 0, Encoding.UTF8.GetBytes(text));

    public static byte[] BoneSizes(params (string Name, float Length)[] bones)
    {
        byte[] payload = new byte[64 * bones.Length];
        for (int i = 0; i < bones.Length; i++)
        {
            Encoding.UTF8.GetBytes(bones[i].Name).CopyTo(payload, i * 64);
            BitConverter.GetBytes(bones[i].Length).CopyTo(payload, (i * 64) + 60);
        }

        return Make(0, bones.Length, 0, 0, payload);
    }

    public static byte[] Make(int id, int dataCount, int parameter, int value, byte[] payload, int? dataLength = null) => new WireBytes()
        .Hex("FF AA  02 00 00 01").U32((uint)(dataLength ?? (64 + payload.Length))).U32((uint)dataCount).U32((uint)id).U32((uint)parameter).U32((uint)value).Zeros(36)
        .Hex("FF BB")
        .Hex(Convert.ToHexString(payload))
        .ToArray();
}
