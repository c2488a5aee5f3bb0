package org.selectiverenderer.x3d.url;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URI;
import java.net.UnknownHostException;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;

/**
 * Fetches files by {@code http} and {@code https} from hosts and ports that the user allows, and
 * from no others: each redirect must lead to an allowed one too. A name that leads to an address of
 * this computer or of a private network is asked only if the user names that address, or the name
 * is {@code localhost}. Files are cached in memory, and failures for a minute. Thread-safe.
 *
 * <p>The address is looked up immediately before each request. The client looks it up again, but
 * Java keeps the answer of a name server for 30 seconds, three times as long as a request may take,
 * so that a server which changes its answer between the two (DNS rebinding) gains nothing. Where
 * the user has set up a proxy, the proxy looks names up itself.
 */
public final class HttpFetcher {
  /** The maximum size of one file in bytes. */
  public static final int MAX_BYTES = 32 << 20;

  /** The maximum size of the cache in bytes, from which the least recently used file is evicted. */
  static final long MAX_KEPT = 8L * MAX_BYTES;

  /** The timeout for one file, including redirects. */
  private static final Duration TIME = Duration.ofSeconds(10);

  private static final int REDIRECTS = 5;

  /** The time for which a failure is cached, since its cause may be removed meanwhile. */
  private static final Duration MEMORY = Duration.ofMinutes(1);

  private final List<HostPattern> hosts;
  private final Duration time;
  private final int maxBytes;
  private final NameLookup names;
  private final AtomicReference<@Nullable HttpClient> client = new AtomicReference<>();
  private final Map<String, CompletableFuture<Fetched>> asked = new ConcurrentHashMap<>();
  private final Map<String, Integer> kept = new LinkedHashMap<>(16, 0.75f, true);
  private long bytesKept;

  /** The result of a request: bytes, or a predicate that says why it failed. */
  private sealed interface Fetched {
    record Bytes(URI from, byte[] data) implements Fetched {}

    record Failed(String clause, long nanoTime) implements Fetched {
      Failed(String clause) {
        this(clause, System.nanoTime());
      }
    }
  }

  /** Thrown if a request of a chain of redirects is refused or fails. */
  private static final class Refusal extends IOException {
    private static final long serialVersionUID = 1L;

    Refusal(String clause) {
      super(clause);
    }
  }

  /** Looks up the addresses of a host. */
  @FunctionalInterface
  interface NameLookup {
    InetAddress[] addresses(String host) throws UnknownHostException;
  }

  /** Creates a fetcher for some hosts. */
  public HttpFetcher(List<HostPattern> hosts) {
    this(hosts, TIME, MAX_BYTES, InetAddress::getAllByName);
  }

  HttpFetcher(List<HostPattern> hosts, Duration time, int maxBytes, NameLookup names) {
    this.hosts = List.copyOf(hosts);
    this.time = time;
    this.maxBytes = maxBytes;
    this.names = names;
  }

  /** Returns a fetcher without any allowed host. */
  public static HttpFetcher none() {
    return new HttpFetcher(List.of());
  }

  /** Returns the allowed hosts. */
  public List<HostPattern> hosts() {
    return hosts;
  }

  boolean allows(URI uri) {
    return hosts.stream().anyMatch(pattern -> pattern.matches(uri));
  }

  /**
   * Returns a file, from the cache or the network, for which it blocks.
   *
   * @param uri an address on an allowed host
   * @throws IOException with a predicate that follows the url
   */
  UrlContent fetch(URI uri) throws IOException {
    URI plain = withoutFragment(uri);
    String key = plain.toString();
    asked.computeIfPresent(key, (same, before) -> stale(before) ? null : before);
    CompletableFuture<Fetched> mine = new CompletableFuture<>();
    CompletableFuture<Fetched> known = asked.putIfAbsent(key, mine);
    if (known == null) {
      Fetched fetched = new Fetched.Failed("could not be fetched");
      try {
        fetched = follow(plain);
      } finally {
        mine.complete(fetched);
      }
      known = mine;
    }
    Fetched fetched = known.join();
    if (fetched instanceof Fetched.Failed failed) {
      throw new IOException(failed.clause());
    }
    Fetched.Bytes bytes = (Fetched.Bytes) fetched;
    used(key, bytes.data().length);
    return new UrlContent.OfBytes(key, uri.toString(), new BaseUrl.Web(bytes.from()), bytes.data());
  }

  private static boolean stale(CompletableFuture<Fetched> before) {
    return before.getNow(new Fetched.Bytes(URI.create(""), new byte[0]))
            instanceof Fetched.Failed failed
        && System.nanoTime() - failed.nanoTime() > MEMORY.toNanos();
  }

  private synchronized void used(String key, int size) {
    Integer before = kept.put(key, size);
    bytesKept += size - (before == null ? 0 : before);
    var oldest = kept.entrySet().iterator();
    while (bytesKept > MAX_KEPT && oldest.hasNext()) {
      Map.Entry<String, Integer> entry = oldest.next();
      if (!entry.getKey().equals(key)) {
        bytesKept -= entry.getValue();
        asked.remove(entry.getKey());
        oldest.remove();
      }
    }
  }

  private Fetched follow(URI start) {
    long end = System.nanoTime() + time.toNanos();
    URI at = start;
    try {
      for (int hop = 0; hop <= REDIRECTS; hop++) {
        HttpResponse<byte[]> response = ask(at, end - System.nanoTime());
        String location = response.headers().firstValue("Location").orElse(null);
        if (response.statusCode() / 100 != 3 || location == null) {
          return response.statusCode() == 200
              ? new Fetched.Bytes(at, response.body())
              : new Fetched.Failed(
                  "cannot be fetched: the server answers " + response.statusCode());
        }
        at = redirected(at, location);
      }
      return new Fetched.Failed("redirects more than %s times".formatted(REDIRECTS));
    } catch (Refusal e) {
      return new Fetched.Failed(String.valueOf(e.getMessage()));
    } catch (IOException e) {
      return new Fetched.Failed("cannot be fetched: " + reason(e));
    }
  }

  private URI redirected(URI from, String location) throws Refusal {
    URI to;
    try {
      to = withoutFragment(from.resolve(location));
    } catch (IllegalArgumentException e) {
      throw new Refusal("redirects to an invalid address");
    }
    String scheme = String.valueOf(to.getScheme()).toLowerCase(Locale.ROOT);
    if (!scheme.equals("https") && !scheme.equalsIgnoreCase(from.getScheme())) {
      throw new Refusal("redirects to " + scheme + ", which is not followed");
    }
    if (to.getHost() == null || to.getUserInfo() != null) {
      throw new Refusal("redirects to an invalid address");
    }
    if (!allows(to)) {
      String host = HostPattern.allowing(to);
      throw new Refusal("redirects to %s; --allow-net %s would allow it".formatted(host, host));
    }
    return to;
  }

  /** Refuses a host whose name leads to this computer or a private network without being named. */
  private void requireNamed(URI uri) throws Refusal {
    String host = uri.getHost();
    if (host.equalsIgnoreCase("localhost")) {
      return; // allowed by its name, which can mean nothing else
    }
    InetAddress[] found;
    try {
      found = names.addresses(host);
    } catch (UnknownHostException e) {
      return; // the request fails by itself, or a proxy knows the name
    }
    for (InetAddress address : found) {
      String text = address.getHostAddress();
      String inUrl = text.indexOf(':') < 0 ? text : '[' + text.replaceFirst("%.*", "") + ']';
      boolean named =
          hosts.stream().anyMatch(pattern -> pattern.names(inUrl))
              || isLiteral(host) && hosts.stream().anyMatch(pattern -> pattern.names(host));
      if (PrivateAddress.is(address) && !named) {
        throw new Refusal(
            ("leads to %s, an address of this computer or of a private network; --allow-net %s as"
                    + " well would allow it")
                .formatted(text, inUrl));
      }
    }
  }

  /** Returns whether the host of a url is an address, not a name. */
  private static boolean isLiteral(String host) {
    return host.startsWith("[") || host.matches("[0-9.]+");
  }

  private HttpResponse<byte[]> ask(URI uri, long nanos) throws IOException {
    Duration left = Duration.ofNanos(Math.max(1, nanos));
    requireNamed(uri);
    HttpRequest request;
    try {
      request =
          HttpRequest.newBuilder(uri)
              .timeout(left)
              .header("User-Agent", "selective-renderer")
              .build();
    } catch (IllegalArgumentException e) {
      throw new Refusal("is not a valid network address");
    }
    CompletableFuture<HttpResponse<byte[]>> answer =
        client().sendAsync(request, info -> new LimitedBodySubscriber(maxBytes));
    try {
      return answer.get(left.toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      answer.cancel(true);
      throw late();
    } catch (InterruptedException e) {
      answer.cancel(true);
      Thread.currentThread().interrupt();
      throw new Refusal("was not fetched, as the program ends");
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      if (cause instanceof java.net.http.HttpTimeoutException) {
        throw late();
      }
      throw cause instanceof IOException failure
          ? failure
          : new IOException(String.valueOf(cause), cause);
    }
  }

  private Refusal late() {
    return new Refusal("does not arrive within %s seconds".formatted(time.toSeconds()));
  }

  private static String reason(IOException e) {
    if (e instanceof java.net.ConnectException) {
      return "the host does not answer";
    }
    Throwable cause = e.getCause();
    String told = e.getMessage() != null || cause == null ? e.getMessage() : cause.getMessage();
    return told == null ? e.getClass().getSimpleName() : told.lines().findFirst().orElse("");
  }

  private HttpClient client() {
    HttpClient known = client.get();
    if (known != null) {
      return known;
    }
    HttpClient made =
        HttpClient.newBuilder()
            .connectTimeout(time)
            .followRedirects(HttpClient.Redirect.NEVER)
            .executor(FetchThreads.executor())
            .build();
    return client.compareAndSet(null, made) ? made : client();
  }

  private static URI withoutFragment(URI uri) {
    String text = uri.toString();
    int fragment = text.indexOf('#');
    return fragment < 0 ? uri : URI.create(text.substring(0, fragment));
  }

  /** Creates the thread pool of a {@link HttpFetcher}: daemon threads that end when idle. */
  private static final class FetchThreads {
    private static final int MOST = 4;

    private FetchThreads() {}

    static Executor executor() {
      AtomicInteger count = new AtomicInteger();
      ThreadPoolExecutor threads =
          new ThreadPoolExecutor(
              MOST,
              MOST,
              2,
              TimeUnit.SECONDS,
              new LinkedBlockingQueue<>(),
              task -> {
                Thread thread = new Thread(task, "scene-network-" + count.incrementAndGet());
                thread.setDaemon(true);
                return thread;
              });
      threads.allowCoreThreadTimeOut(true);
      return threads;
    }
  }
}
