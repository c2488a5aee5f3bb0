package org.selectiverenderer.enricher.ratings;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.ratings.GazeProposal;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher.Match;
import org.selectiverenderer.authoring.ratings.Ratings;
import org.selectiverenderer.authoring.ratings.ViewedObjects;

/**
 * The proposals from head logs under review, and which of them the author has accepted. Not
 * thread-safe.
 */
final class GazeImport {
  private record Key(String object, String schema) {
    static Key of(GazeProposal proposal) {
      return new Key(proposal.object(), proposal.schema());
    }
  }

  private final Set<Key> accepted = new HashSet<>();
  private @Nullable GazeProposals logs;
  private List<GazeProposal> proposals = List.of();

  /** Uses proposals; those accepted before stay so where they still say something. */
  void take(GazeProposals read, List<GazeProposal> fresh) {
    logs = read;
    proposals = List.copyOf(fresh);
    accepted.retainAll(proposals.stream().filter(GazeProposal::applicable).map(Key::of).toList());
  }

  /** The logs that were read; null for none. */
  @Nullable GazeProposals logs() {
    return logs;
  }

  List<GazeProposal> proposals() {
    return proposals;
  }

  boolean accepted(GazeProposal proposal) {
    return accepted.contains(Key.of(proposal));
  }

  void accept(GazeProposal proposal, boolean accept) {
    if (accept && proposal.applicable()) {
      accepted.add(Key.of(proposal));
    } else {
      accepted.remove(Key.of(proposal));
    }
  }

  /** Whether what follows for an object and a schema comes from an accepted proposal. */
  boolean told(String object, String schema) {
    return chosen().stream()
        .anyMatch(each -> each.object().equals(object) && each.schema().equals(schema));
  }

  /** The accepted proposals. */
  List<GazeProposal> chosen() {
    return proposals.stream().filter(this::accepted).toList();
  }

  /** Ratings with the accepted proposals in the place of those of the same object and schema. */
  Ratings onto(Ratings ratings, ViewedObjects objects) {
    return objects.with(ratings, chosen());
  }

  /**
   * The Switches of the objects of such ratings: as the author has matched those of the table; an
   * object of the logs is the Switch of its name.
   */
  static ObjectNameMatcher matching(
      Ratings combined, @Nullable ObjectNameMatcher table, DocumentEnrichment enrichment) {
    Map<String, ?> means = combined.means();
    ObjectNameMatcher all = new ObjectNameMatcher(means.keySet(), enrichment.switches());
    Set<String> own = new HashSet<>(means.keySet());
    Stream<Match> matches = table == null ? Stream.empty() : table.matches().stream();
    matches.forEach(
        match -> {
          own.remove(match.object());
          if (match.how() == ObjectNameMatcher.How.CHOSEN) {
            all.choose(match.object(), match.switchName().orElseThrow());
          } else if (match.how() == ObjectNameMatcher.How.NONE) {
            all.leaveOut(match.object());
          }
        });
    own.forEach(name -> all.choose(name, name));
    return all;
  }
}
