package org.selectiverenderer.x3d.url;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.x3d.url.UrlResolver.Cause;
import org.selectiverenderer.x3d.url.UrlResolver.Target;

class HttpFetcherTest {
  @TempDir private Path folder;
  private HttpServer server;
  private String host;
  private String here;
  private final ConcurrentLinkedQueue<String> asked = new ConcurrentLinkedQueue<>();
  private final CountDownLatch over = new CountDownLatch(1);

  @BeforeEach
  void serve() throws IOException {
    server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    here = "127.0.0.1:" + server.getAddress().getPort();
    host = "http://" + here;
    server.createContext(
        "/",
        exchange -> {
          String path = exchange.getRequestURI().toString();
          asked.add(path);
          if (path.startsWith("/to?")) {
            exchange.getResponseHeaders().add("Location", path.substring(4));
            exchange.sendResponseHeaders(302, -1);
          } else if (path.equals("/slow")) {
            await();
          } else if (path.startsWith("/none")) {
            exchange.sendResponseHeaders(404, -1);
          } else {
            byte[] body = (path.startsWith("/big") ? "x".repeat(5000) : path).getBytes(UTF_8);
            exchange.sendResponseHeaders(200, path.equals("/big-unsaid") ? 0 : body.length);
            exchange.getResponseBody().write(body);
          }
          exchange.close();
        });
    server.setExecutor(task -> new Thread(task, "test-server").start());
    server.start();
  }

  private void await() {
    try {
      over.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @AfterEach
  void stop() {
    over.countDown();
    server.stop(0);
  }

  /** Long, so that a busy machine does not make a server slow. */
  private Duration patience = Duration.ofSeconds(30);

  private UrlResolver root(String... hosts) {
    return root(InetAddress::getAllByName, hosts);
  }

  private UrlResolver root(HttpFetcher.NameLookup names, String... hosts) {
    HttpFetcher network =
        new HttpFetcher(
            List.of(hosts).stream().map(HostPattern::new).toList(), patience, 1000, names);
    return new UrlResolver(folder, new ContentAccessPolicy(List.of(), network));
  }

  private String read(UrlResolver root, String url) throws IOException {
    Target target = root.resolve(url, folder);
    return target instanceof Target.Found found
        ? new String(found.content().bytes(10_000), UTF_8)
        : ((Target.Refused) target).cause() + " " + ((Target.Refused) target).reason();
  }

  @Test
  void nothingIsFetchedUnlessTheHostIsNamed() throws IOException {
    assertThat(read(root(), host + "/a"))
        .isEqualTo("NETWORK is on the network; --allow-net %s would allow it".formatted(here));
    assertThat(read(root("localhost"), host + "/a")).startsWith("NETWORK");
    assertThat(read(root("127.0.0.1", "127.0.0.1:1"), host + "/a")).startsWith("NETWORK");
    assertThat(asked).isEmpty();
  }

  @Test
  void aFileIsFetchedOnceAndItsRelativeUrlsLeadToTheSameServer() throws IOException {
    UrlResolver root = root(here);
    assertThat(read(root, host + "/models/desk one.x3d")).isEqualTo("/models/desk%20one.x3d");
    assertThat(read(root, host + "/models/desk one.x3d#Top")).isEqualTo("/models/desk%20one.x3d");
    Target.Found desk = (Target.Found) root.resolve(host + "/models/desk one.x3d", folder);
    Target.Found leg = (Target.Found) root.resolve("../leg.x3d", desk.content().base());
    assertThat(leg.content().name()).isEqualTo(host + "/leg.x3d");
    assertThat(asked).containsExactly("/models/desk%20one.x3d", "/leg.x3d");
  }

  @Test
  void aFileOfTheNetworkNamesNoneOfThisMachine() throws IOException {
    UrlResolver root = root(here);
    Target.Found page = (Target.Found) root.resolve(host + "/a", folder);
    Target target = root.resolve("file:///etc/hostname", page.content().base());
    assertThat(((Target.Refused) target).cause()).isEqualTo(Cause.OUTSIDE);
  }

  @Test
  void redirectsLeadToAllowedHostsOnly() throws IOException {
    UrlResolver root = root(here);
    assertThat(read(root, host + "/to?" + host + "/b")).isEqualTo("/b");
    String named = here.replace("127.0.0.1", "localhost");
    assertThat(read(root, host + "/to?http://" + named + "/secret"))
        .isEqualTo(
            "UNREACHABLE redirects to %s; --allow-net %s would allow it".formatted(named, named));
    assertThat(read(root, host + "/to?file:///etc/hostname"))
        .isEqualTo("UNREACHABLE redirects to file, which is not followed");
    assertThat(read(root, host + "/to?" + "/to?".repeat(7) + "/c"))
        .isEqualTo("UNREACHABLE redirects more than 5 times");
    assertThat(asked).doesNotContain("/secret");
  }

  @Test
  void redirectsLeadToAllowedPortsOnly() throws IOException {
    HttpServer other =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    other.createContext(
        "/",
        exchange -> {
          asked.add("/other");
          exchange.sendResponseHeaders(404, -1);
          exchange.close();
        });
    other.start();
    try {
      String there = "127.0.0.1:" + other.getAddress().getPort();
      assertThat(read(root(here, "127.0.0.1"), host + "/to?http://" + there + "/admin"))
          .isEqualTo(
              "UNREACHABLE redirects to %s; --allow-net %s would allow it".formatted(there, there));
      assertThat(asked).doesNotContain("/other");
    } finally {
      other.stop(0);
    }
  }

  @Test
  void aNameThatLeadsToThisComputerIsAskedOnlyIfTheAddressIsNamedToo() throws IOException {
    String port = here.substring(here.indexOf(':'));
    HttpFetcher.NameLookup rebound = name -> new InetAddress[] {InetAddress.getLoopbackAddress()};
    assertThat(read(root(rebound, "models.example" + port), "http://models.example" + port + "/a"))
        .isEqualTo(
            "UNREACHABLE leads to 127.0.0.1, an address of this computer or of a private network;"
                + " --allow-net 127.0.0.1 as well would allow it");
    assertThat(
            read(
                root(rebound, "models.example" + port, "127.0.0.1"),
                "http://models.example" + port + "/a"))
        .startsWith("UNREACHABLE cannot be fetched: "); // the name itself is nowhere
    assertThat(read(root("localhost" + port), "http://localhost" + port + "/a")).isEqualTo("/a");
    assertThat(asked).containsExactly("/a");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "0.0.0.0",
        "10.1.2.3",
        "100.64.0.1",
        "127.8.9.1",
        "169.254.169.254",
        "172.16.0.9",
        "192.168.1.1",
        "224.0.0.1",
        "255.255.255.255",
        "::",
        "::1",
        "fe80::1",
        "fd00::1",
        "::ffff:10.0.0.1",
        "64:ff9b::a00:1",
        "2002:a00:1::"
      })
  void anAddressOfThisComputerOrOfItsNetworkIsPrivate(String address) throws IOException {
    assertThat(PrivateAddress.is(InetAddress.getByName(address))).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"93.184.215.14", "100.128.0.1", "172.32.0.1", "2606:2800:21f::1"})
  void anAddressOfTheInternetIsNotPrivate(String address) throws IOException {
    assertThat(PrivateAddress.is(InetAddress.getByName(address))).isFalse();
  }

  @Test
  void aRefusalIsRemembered() throws IOException {
    UrlResolver root = root(here);
    String answer = "UNREACHABLE cannot be fetched: the server answers 404";
    assertThat(read(root, host + "/none")).isEqualTo(answer);
    assertThat(read(root, host + "/none")).isEqualTo(answer);
    assertThat(asked).containsExactly("/none");
  }

  @Test
  void whatIsTooLargeOrTooSlowIsLeft() throws IOException {
    patience = Duration.ofSeconds(1);
    UrlResolver root = root(here);
    String large =
        "UNREACHABLE cannot be fetched: the file has more than 1000 bytes, which is the limit";
    assertThat(read(root, host + "/big")).isEqualTo(large);
    assertThat(read(root, host + "/big-unsaid")).isEqualTo(large);
    assertThat(read(root, host + "/slow"))
        .isEqualTo("UNREACHABLE does not arrive within 1 seconds");
  }

  @Test
  void aServerThatDoesNotAnswerIsNamed() throws IOException {
    UrlResolver root = root(here);
    server.stop(0);
    assertThat(read(root, host + "/a")).startsWith("UNREACHABLE cannot be fetched: ");
  }

  @Test
  void threadsAreNamedAndDoNotKeepTheProgramRunning() throws IOException {
    read(root(here), host + "/a");
    Set<Thread> threads =
        Thread.getAllStackTraces().keySet().stream()
            .filter(thread -> thread.getName().startsWith("scene-network-"))
            .collect(Collectors.toSet());
    assertThat(threads).isNotEmpty().allMatch(Thread::isDaemon);
  }
}
