package org.selectiverenderer.x3d.read;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Provides a reader with the prototypes of other files. Thread-safe. */
public interface PrototypeLibraryProvider {
  /** The result of looking for a library. */
  sealed interface Answer {
    /**
     * A library.
     *
     * @param fragment the part of the url after the sign #, which is the prototype's name
     */
    record Found(PrototypeLibrary library, String fragment) implements Answer {}

    /**
     * No readable library.
     *
     * @param reason a clause that follows "the prototype cannot be loaded: "
     */
    record None(String reason) implements Answer {}
  }

  /**
   * Returns the library at the first readable url. May block until it is read.
   *
   * @param base the base of relative urls
   */
  Answer find(List<String> urls, BaseUrl base);

  /** Returns what decides which files a scene may refer to; empty if it may refer to none. */
  default Optional<UrlResolver> files() {
    return Optional.empty();
  }

  /** Returns a provider without other files. */
  static PrototypeLibraryProvider none() {
    return (urls, base) -> new Answer.None("it is in another file, which is not read here");
  }
}
