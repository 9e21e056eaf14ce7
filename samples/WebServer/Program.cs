// Sends motion to browsers over a WebSocket, and encrypted to NeuronMocap readers. Ctrl+C ends it.
// --source HOST[:PORT] receives from a suit instead of the simulator; --web PORT and --tls PORT choose other ports, 0 for any.
// Exit code: 0 ended as requested, 2 the source is not an address.

using System.Net;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using NeuronMocap;
using NeuronMocap.AspNetCore;
using NeuronMocap.Server;

WebApplicationBuilder builder = WebApplication.CreateBuilder(args);
using X509Certificate2 certificate = CreateCertificate();
File.WriteAllText("server.pem", certificate.ExportCertificatePem());

await using Broadcaster? demo = builder.Configuration["source"] is null ? Broadcaster.StartDemo() : null;
NeuronReaderOptions options;
try
{
    options = NeuronReaderOptions.Parse(builder.Configuration["source"] ?? $"{demo!.LocalEndPoint}");
}
catch (FormatException exception)
{
    Console.Error.WriteLine(exception.Message);
    return 2;
}

await using var reader = new NeuronReader(options);
await using var relay = new Broadcaster(new BroadcasterOptions { Reader = reader, Port = null });
await using var web = new WebSocketBroadcaster(reader);

builder.WebHost.ConfigureKestrel(kestrel =>
{
    kestrel.Listen(IPAddress.Loopback, builder.Configuration.GetValue("web", 7100));
    kestrel.Listen(IPAddress.Any, builder.Configuration.GetValue("tls", 7443), listen => listen.UseHttps(certificate).UseNeuronBroadcast(relay));
});
WebApplication application = builder.Build();
application.MapNeuronWebSocket("/", web);
reader.StatusChanged += status => Console.WriteLine(status.Message);
relay.Start();
reader.Start();
await application.RunAsync();
return 0;

// For this example. A real server has a certificate that its clients trust, and a key that stays the same.
static X509Certificate2 CreateCertificate()
{
    using var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
    using X509Certificate2 certificate = new CertificateRequest("CN=localhost", key, HashAlgorithmName.SHA256)
        .CreateSelfSigned(DateTimeOffset.UtcNow.AddDays(-1), DateTimeOffset.UtcNow.AddYears(1));
    return X509CertificateLoader.LoadPkcs12(certificate.Export(X509ContentType.Pkcs12), password: null);
}
