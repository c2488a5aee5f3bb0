package org.selectiverenderer.validation.files;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.Set;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneContext;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Finds files that inline themselves, directly or through others. */
final class InlineCycleCheck implements SceneCheck {
  /** A file on the path of the depth-first traversal, with the index of its next node. */
  private static final class Step {
    final FileOutline file;
    int next;

    Step(FileOutline file) {
      this.file = file;
    }
  }

  // The traversal is iterative, since a chain of files may be deeper than the call stack.
  @Override
  public void check(SceneContext scene, FindingCollector findings) {
    Set<FileOutline> open = Collections.newSetFromMap(new IdentityHashMap<>());
    Set<FileOutline> done = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<Step> way = new ArrayDeque<>();
    way.push(new Step(scene.main()));
    open.add(scene.main());
    for (Step step = way.peek(); step != null; step = way.peek()) {
      if (step.next == step.file.nodes().size()) {
        way.pop();
        open.remove(step.file);
        done.add(step.file);
        continue;
      }
      ParsedNode node = step.file.nodes().get(step.next++);
      FileOutline inlined = scene.content(node).orElse(null);
      if (inlined != null && open.contains(inlined)) {
        findings.add(
            FileRules.CIRCLE,
            step.file.place(node, "url"),
            node.type().name(),
            inlined.file().name());
      } else if (inlined != null && !done.contains(inlined)) {
        way.push(new Step(inlined));
        open.add(inlined);
      }
    }
  }
}
