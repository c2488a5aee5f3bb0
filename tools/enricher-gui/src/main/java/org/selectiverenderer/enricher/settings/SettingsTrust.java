package org.selectiverenderer.enricher.settings;

import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.base.trust.TrustStore;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * Keeps the settings file beside a scene, which comes with the scene, from opening folders and
 * hosts before the author has agreed. The author is asked once, while the scene is checked without
 * them. Thread-safe.
 */
public final class SettingsTrust {
  private final TrustStore store;
  private final Question question;
  private final Set<Set<String>> asked = ConcurrentHashMap.newKeySet();
  private final Set<Set<String>> agreed = ConcurrentHashMap.newKeySet();

  /** Asks the author; returns at once, and hands the answer over later. */
  @FunctionalInterface
  public interface Question {
    void ask(String sentence, List<String> lines, Consumer<Boolean> answer);
  }

  /**
   * @param store remembers what the author has agreed to
   */
  public SettingsTrust(TrustStore store, Question question) {
    this.store = store;
    this.question = question;
  }

  /**
   * Returns the settings, without folders and hosts that the author has not agreed to, which is
   * then in {@code problems}.
   *
   * @param opened runs when the author agrees, after which the settings must be read again
   */
  public ValidationSettings limited(
      ValidationSettings read, ProblemCollector problems, Runnable opened) {
    PermissionRequests wanted = read.permissions();
    Set<String> digest = wanted.digests();
    if (wanted.isEmpty() || agreed.contains(digest) || store.remembers(wanted)) {
      return read;
    }
    String file = String.valueOf(read.file());
    if (asked.add(digest)) {
      question.ask(
          Texts.of("keep.trust", file),
          wanted.lines(),
          yes -> {
            if (yes) {
              agreed.add(digest);
              remember(wanted);
              opened.run();
            }
          });
    }
    problems.warning(SourceLocation.of(file), Texts.of("keep.untrusted"));
    return read.allowing(ContentAccessPolicy.none());
  }

  private void remember(PermissionRequests wanted) {
    try {
      store.remember(wanted);
    } catch (IOException e) {
      return; // the answer holds until the window is closed
    }
  }
}
