namespace NeuronMocap.Data.Tests.Vendor;

/// <summary>The notation of the vendor's tables. Needs no file of the folder shared, so that this project always has tests.</summary>
public sealed class VendorFieldTests
{
    [Fact]
    public void A_type_belongs_to_all_names_up_to_the_next_type()
    {
        Assert.Equal(
            [new("ushort", "Token1", null), new("DataVersion", "DataVersion", null), new("UInt32", "DataCount", null), new("UInt32", "AvatarIndex", null)],
            VendorField.Parse("ushort `Token1`; `DataVersion`; UInt32 `DataCount`, `AvatarIndex`"));
    }

    [Theory]
    [InlineData("string `AvatarName` (ByValTStr 32)", 32)]
    [InlineData("byte `Major`", 1)]
    [InlineData("ushort `Token1`", 2)]
    [InlineData("`DataVersion`", 4)]
    public void A_field_has_its_size_in_unmanaged_memory(string text, int bytes) => Assert.Equal(bytes, Assert.Single(VendorField.Parse(text)).Bytes);

    [Fact]
    public void An_unknown_type_is_named()
    {
        VendorField field = Assert.Single(VendorField.Parse("long `Time`"));
        Assert.Contains("long", Assert.Throws<InvalidDataException>(() => field.Bytes).Message, StringComparison.Ordinal);
    }
}
