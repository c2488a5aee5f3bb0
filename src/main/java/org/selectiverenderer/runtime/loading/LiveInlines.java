package org.selectiverenderer.runtime.loading;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.NodeObserver;
import org.selectiverenderer.runtime.scene.Scene;

/**
 * Fills the Inlines of a running scene anew when their fields change. {@code load FALSE} empties
 * one at once; its content is kept and is back at once with {@code load TRUE} unless the url has
 * changed meanwhile. Of several changes in a row the last one counts. One that leaves the scene
 * while it is read asks again when it comes back.
 */
final class LiveInlines {
  private final LiveFiles files;
  private final LiveImports imports;
  private final Map<InlineNode, Watch> watched = new IdentityHashMap<>();
  private final List<Watch> changed = new ArrayList<>();

  /** Those whose scenes import something, of all that are watched. */
  private final Set<InlineNode> importing = Collections.newSetFromMap(new IdentityHashMap<>());

  LiveInlines(LiveFiles files, LiveImports imports) {
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

  /** An Inline has the content that it has; costs the same however many others there are. */
  private void filled(InlineNode inline) {
    if (inline.content().filter(content -> !content.imports().isEmpty()).isPresent()) {
      importing.add(inline);
    } else {
      importing.remove(inline);
    }
  }

  /** One Inline. */
  private final class Watch implements NodeObserver {
    private final InlineNode inline;
    private final int load;

    /** The url whose content the Inline has, or is waiting for; null for none. */
    private String @Nullable [] requested;

    /** Whether it is waiting. */
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
