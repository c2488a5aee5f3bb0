package org.selectiverenderer.x3d.read;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.IoErrorFormatter;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Loads the prototype libraries to which the files of one scene refer. Each is read once, by the
 * first thread that needs it, and other threads wait. A library is read without the libraries that
 * it refers to, so that cyclic references cannot deadlock.
 */
public final class PrototypeLibraryLoader implements PrototypeLibraryProvider {
  private final X3dReader reader;
  private final UrlResolver root;
  private final Map<String, CompletableFuture<Read>> known = new ConcurrentHashMap<>();

  /**
   * The result of reading a library.
   *
   * @param library the library; null if it could not be read
   * @param fault the error, else empty
   */
  private record Read(@Nullable PrototypeLibrary library, String fault) {}

  /** Creates a loader of the files that a root resolves. */
  public PrototypeLibraryLoader(X3dReader reader, UrlResolver root) {
    this.reader = reader;
    this.root = root;
  }

  @Override
  public Optional<UrlResolver> files() {
    return Optional.of(root);
  }

  @Override
  public Answer find(List<String> urls, BaseUrl base) {
    String reason = "";
    for (String url : urls) {
      UrlResolver.Target target = root.resolve(url, base);
      String fault;
      if (target instanceof UrlResolver.Target.Found found) {
        Read read = read(found.content());
        if (read.library() != null) {
          return new Answer.Found(read.library(), found.fragment());
        }
        fault = read.fault();
      } else {
        fault = ((UrlResolver.Target.Refused) target).reason();
      }
      reason =
          reason.isEmpty() ? "url '%s' %s".formatted(ResolvedUrlContent.shown(url), fault) : reason;
    }
    return new Answer.None(reason.isEmpty() ? "it has no url" : reason);
  }

  private Read read(UrlContent content) {
    CompletableFuture<Read> mine = new CompletableFuture<>();
    CompletableFuture<Read> before = known.putIfAbsent(content.key(), mine);
    if (before != null) {
      return before.join();
    }
    Read read = new Read(null, "could not be read");
    try {
      read = new Read(reader.library(content), "");
    } catch (IOException e) {
      // the exception's message would contain the absolute path
      read =
          new Read(
              null,
              e instanceof FileSystemException
                  ? IoErrorFormatter.clause(e)
                  : "cannot be read (%s)".formatted(e.getMessage()));
    } finally {
      mine.complete(read);
    }
    return read;
  }
}
