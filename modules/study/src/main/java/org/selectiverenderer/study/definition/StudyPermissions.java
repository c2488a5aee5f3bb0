package org.selectiverenderer.study.definition;

import java.nio.file.Path;
import java.util.function.Predicate;
import org.selectiverenderer.apparatus.DisplayProfileLoader;
import org.selectiverenderer.base.trust.PermissionRequest;
import org.selectiverenderer.base.trust.PermissionRequest.Kind;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.study.definition.StudyQuestionnaires.Content;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.x3d.url.OutsideRequests;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Collects what a study asks for beyond its own folder: every key of a study that names a file, a
 * folder, a host, a device or a stream. A key that comes to reach outside is added here.
 */
public final class StudyPermissions {
  private StudyPermissions() {}

  /** Returns all requests of a study. */
  public static PermissionRequests of(Study study) {
    OutsideRequests requests = new OutsideRequests(study.file());
    study.scene().ifPresent(file -> requests.scene("scene", file));
    study.practice().ifPresent(practice -> requests.scene("practice", practice.scene()));
    study.questionnaires().form().ifPresent(file -> requests.file("form", file));
    for (StudyQuestionnaires.Source source : study.questionnaires().list()) {
      if (source.content() instanceof Content.Items items) {
        requests.file("items", items.file());
      } else if (source.content() instanceof Content.Own own) {
        requests.file("file", own.file());
      }
    }
    study.design().audio().forEach(file -> requests.file("audio", file));
    String profile = study.display().hmd();
    if (DisplayProfileLoader.builtIn(profile).isEmpty()) {
      requests.file("hmd", Path.of(profile));
    }
    for (String language : study.languages()) {
      requests.file("language", ParticipantMessages.file(language, study.folder()));
    }
    requests.access(study.access());
    tracker(requests, study.tracker());
    streams(requests, study.streams());
    study
        .triggers()
        .ifPresent(
            triggers ->
                requests.add(
                    new PermissionRequest(
                        Kind.TRIGGER,
                        "triggers",
                        triggers.port(),
                        "opens the serial port " + triggers.port() + " and sends signals by it")));
    return requests.requests();
  }

  /**
   * Returns which pictures a questionnaire may show: the study's own, those in the folders that the
   * study asks for, and those that are the questionnaire's own.
   */
  public static Predicate<Path> pictures(Study study, Path questionnaire) {
    UrlResolver own = new UrlResolver(study.folder(), study.access());
    UrlResolver beside = new UrlResolver(questionnaire.toAbsolutePath().resolveSibling(""));
    return picture -> own.mayBeNamed(picture) || beside.mayBeNamed(picture);
  }

  private static void tracker(OutsideRequests requests, TrackerSpec tracker) {
    String meaning =
        tracker instanceof TrackerSpec.InterTrax2 serial
            ? serial.searched()
                ? "sends a request to each serial port of this computer, to find an InterTrax2"
                : "opens the serial port " + serial.port()
            : tracker instanceof TrackerSpec.Fastrak serial
                ? "opens the serial port " + serial.port()
                : tracker instanceof TrackerSpec.OpenTrack socket
                    ? listens(socket)
                    : "connects to " + tracker;
    if (!(tracker instanceof TrackerSpec.None) && !(tracker instanceof TrackerSpec.Headset)) {
      requests.add(
          new PermissionRequest(Kind.TRACKER, "tracker", String.valueOf(tracker), meaning));
    }
  }

  private static String listens(TrackerSpec.OpenTrack socket) {
    String port = "listens at the UDP port " + socket.port();
    return switch (socket.host()) {
      case "" -> port + " to programs of this computer";
      case "*" -> port + " to the whole network";
      default -> port + " of the address " + socket.host();
    };
  }

  private static void streams(OutsideRequests requests, LslSettings streams) {
    if (streams.lsl()) {
      requests.add(
          new PermissionRequest(
              Kind.STREAM,
              "lsl",
              "send",
              "sends the participant's id, poses, gaze and events to the local network (Lab"
                  + " Streaming Layer)"));
    }
    for (String condition : streams.record()) {
      requests.add(
          new PermissionRequest(
              Kind.STREAM,
              "record",
              condition,
              "records the streams of the local network with %s (Lab Streaming Layer)"
                  .formatted(condition)));
    }
  }
}
