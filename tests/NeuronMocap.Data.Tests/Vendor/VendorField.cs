using System.Text.RegularExpressions;

namespace NeuronMocap.Data.Tests.Vendor;

/// <summary>A field of a vendor struct in the notation of the table, such as "UInt32 `DataCount`" or "string `AvatarName` (ByValTStr 32)".</summary>
internal sealed partial record VendorField(string Type, string Name, int? Size)
{
    /// <summary>Size in unmanaged memory, in bytes.</summary>
    public int Bytes => Size ?? Type switch
    {
        "byte" => 1,
        "ushort" => 2,
        "UInt32" or "uint" or "float" or "CmdId" or "DataVersion" => 4,
        _ => throw new InvalidDataException($"The table has a type that this test does not know: {Type}"),
    };

    // In "ushort `Token1`; `DataVersion`; UInt32 `DataCount`, `AvatarIndex`", a type applies to all names up to the next type. A single name is its
    // own type.
    public static IReadOnlyList<VendorField> Parse(string text)
    {
        var fields = new List<VendorField>();
        foreach (string part in text.Split(';'))
        {
            string type = "";
            foreach (Match match in Field().Matches(part))
            {
                string name = match.Groups["name"].Value;
                type = match.Groups["type"].Value is { Length: > 0 } own ? own : type.Length > 0 ? type : name;
                int? size = match.Groups["size"].Value is { Length: > 0 } digits ? int.Parse(digits, System.Globalization.CultureInfo.InvariantCulture) : null;
                fields.Add(new VendorField(type, name, size));
            }
        }

        return fields;
    }

    [GeneratedRegex(@"(?:(?<type>[A-Za-z0-9]+(?:\[\])?) )?`(?<name>\w+)`(?: \((?:ByVal\w+ )?(?<size>\d+)\))?", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Field();
}
