package org.selectiverenderer.x3d.read;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.Failure;
import org.selectiverenderer.x3d.files.UrlChoice;

/**
 * The libraries that the files of one scene name. Each is read once, by the thread that asks first;
 * others wait for it. None waits for another: a library is read without what it names in turn, so
 * that libraries that name one another are no trouble.
 */
public final class FileLibraries implements Libraries {
  private final X3dReader reader;
  private final ContentRoot root;
  private final Map<String, CompletableFuture<Read>> known = new ConcurrentHashMap<>();

  /**
   * @param library null when it could not be read
   * @param fault why, else empty
   */
  private record Read(@Nullable PrototypeLibrary library, String fault) {}

  /** Prototypes of files that a reader reads and a root allows. */
  public FileLibraries(X3dReader reader, ContentRoot root) {
    this.reader = reader;
    this.root = root;
  }

  @Override
  public Answer find(List<String> urls, ContentBase base) {
    String reason = "";
    for (String url : urls) {
      ContentRoot.Target target = root.resolve(url, base);
      String fault;
      if (target instanceof ContentRoot.Target.Found found) {
        Read read = read(found.content());
        if (read.library() != null) {
          return new Answer.Found(read.library(), found.fragment());
        }
        fault = read.fault();
      } else {
        fault = ((ContentRoot.Target.Refused) target).reason();
      }
      reason = reason.isEmpty() ? "url '%s' %s".formatted(UrlChoice.shown(url), fault) : reason;
    }
    return new Answer.None(reason.isEmpty() ? "it has no url" : reason);
  }

  private Read read(Content content) {
    CompletableFuture<Read> mine = new CompletableFuture<>();
    CompletableFuture<Read> before = known.putIfAbsent(content.key(), mine);
    if (before != null) {
      return before.join();
    }
    Read read = new Read(null, "could not be read");
    try {
      read = new Read(reader.library(content), "");
    } catch (IOException e) {
      // Its own message names the file by its absolute path.
      read =
          new Read(
              null,
              e instanceof FileSystemException
                  ? Failure.clause(e)
                  : "cannot be read (%s)".formatted(e.getMessage()));
    } finally {
      mine.complete(read);
    }
    return read;
  }
}
