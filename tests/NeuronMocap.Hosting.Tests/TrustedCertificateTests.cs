using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Options;

namespace NeuronMocap.Hosting.Tests;

public sealed class TrustedCertificateTests : IDisposable
{
    private const string Setting = "Tls:TrustedCertificate";

    private readonly string _folder = Directory.CreateTempSubdirectory("certificate-").FullName;
    private readonly string _file;

    public TrustedCertificateTests() => _file = Path.Combine(_folder, "server.pem");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    // A service runs in a folder of the system, such as / or C:\Windows\System32.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void The_certificate_is_read_from_the_folder_of_the_host(bool isRelative)
    {
        using var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        using X509Certificate2 certificate = new CertificateRequest("CN=stage", key, HashAlgorithmName.SHA256)
            .CreateSelfSigned(DateTimeOffset.UtcNow, DateTimeOffset.UtcNow.AddDays(1));
        File.WriteAllText(_file, certificate.ExportCertificatePem());

        Assert.Equal(certificate.RawData, Read(isRelative ? "server.pem" : _file).Tls?.TrustedCertificate?.RawData);
    }

    [Fact]
    public void A_missing_file_is_said_to_be_missing() =>
        Assert.Equal($"{Setting} is '{_file}'; it must be a file that exists.", FindFault("server.pem"));

    [Fact]
    public void A_file_without_a_certificate_is_said_to_have_none()
    {
        File.WriteAllText(_file, "no certificate");
        Assert.Equal($"{Setting} is '{_file}'; it must be a file that holds a certificate in PEM or DER form.", FindFault("server.pem"));
    }

    [Theory]
    [InlineData(".")]
    [InlineData("a\0b")]
    public void A_name_that_no_file_can_have_is_a_fault_of_the_setting(string name) => Assert.StartsWith($"{Setting} is ", FindFault(name), StringComparison.Ordinal);

    [Fact]
    public void An_empty_name_is_no_certificate() => Assert.Null(Read(string.Empty).Tls);

    private string FindFault(string name) => Assert.Single(Assert.Throws<OptionsValidationException>(() => Read(name)).Failures);

    private NeuronReaderOptions Read(string name)
    {
        HostApplicationBuilder builder = Host.CreateEmptyApplicationBuilder(new HostApplicationBuilderSettings { ContentRootPath = _folder });
        builder.Configuration.AddInMemoryCollection([KeyValuePair.Create($"NeuronReader:{Setting}", (string?)name)]);
        builder.Services.AddNeuronReader();
        using IHost host = builder.Build();
        return host.Services.GetRequiredService<IOptions<NeuronReaderOptions>>().Value;
    }
}
