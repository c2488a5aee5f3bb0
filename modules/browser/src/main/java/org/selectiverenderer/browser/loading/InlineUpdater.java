package org.selectiverenderer.browser.loading;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.browser.scene.Scene;

/**
 * Reloads the Inlines of a running scene when their fields change. {@code load FALSE} empties an
 * Inline at once; its content is kept and reappears at once with {@code load TRUE} unless the url
 * has changed meanwhile. Of several changes in a row the last one counts. An Inline that leaves the
 * scene while its file is being read requests it again when it returns.
 */
final class InlineUpdater {
  private final RunningSceneLoader files;
  private final ImportUpdater imports;
  private final Map<InlineNode, Watch> watched = new IdentityHashMap<>();
  private final List<Watch> changed = new ArrayList<>();

  /** The watched Inlines whose scenes import anything. */
  private final Set<InlineNode> importing = Collections.newSetFromMap(new IdentityHashMap<>());

  InlineUpdater(RunningSceneLoader files, ImportUpdater imports) {
    this.files = files;
    this.imports = imports;
  }

  void watch(Collection<InlineNode> present) {
    Set<InlineNode> now = Collections.newSetFromMap(new IdentityHashMap<>());
    now.addAll(present);
    watched
        .values()
        .removeIf(
            watch -> {
              boolean gone = !now.contains(watch.inline);
              if (gone) {
                watch.inline.removeObserver(watch);
                watch.requested = null;
              }
              return gone;
            });
    importing.clear();
    for (InlineNode inline : present) {
      watched.computeIfAbsent(inline, Watch::new);
      filled(inline);
    }
  }

  void update() {
    List<Watch> now = List.copyOf(changed);
    changed.clear();
    now.forEach(Watch::update);
    if (!now.isEmpty()) {
      imports.refresh(importing);
    }
  }

  /**
   * Updates the imports after an Inline got content; the cost does not depend on the number of
   * Inlines.
   */
  private void filled(InlineNode inline) {
    if (inline.content().filter(content -> !content.imports().isEmpty()).isPresent()) {
      importing.add(inline);
    } else {
      importing.remove(inline);
    }
  }

  /** The observer of one Inline. */
  private final class Watch implements NodeObserver {
    private final InlineNode inline;
    private final int load;

    /** The url whose content the Inline has or is waiting for; null for none. */
    private String @Nullable [] requested;

    /** Whether the content has been requested and not arrived. */
    private boolean waiting;

    Watch(InlineNode inline) {
      this.inline = inline;
      load = inline.type().indexOf("load");
      inline.addObserver(this);
      requested = inline.asked();
      if (requested != url()) {
        changed.add(this);
      }
    }

    private String[] url() {
      return inline.strings("url");
    }

    @Override
    public void changed(Node node, int field) {
      if (field == load || field == inline.urlField()) {
        changed.add(this);
      }
    }

    void update() {
      String[] wanted = url();
      if (!inline.bool("load")) {
        if (waiting) {
          requested = inline.asked();
          waiting = false;
        }
      } else if (requested != wanted) {
        requested = wanted;
        waiting = true;
        files.inline(inline, content -> arrived(wanted, content));
      }
    }

    private void arrived(String[] url, Optional<Scene> content) {
      if (requested == url && waiting) {
        waiting = false;
        inline.asked(url);
        double scale = content.map(Scene::unitLength).orElse(1.0) / files.unitLength(inline);
        inline.refill(content.orElse(null), content.isPresent() ? scale : 1);
        filled(inline);
        imports.refresh(importing);
      }
    }
  }
}
