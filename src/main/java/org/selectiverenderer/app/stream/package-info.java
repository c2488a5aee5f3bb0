/**
 * The Lab Streaming Layer (LSL) streams of a run or a session.
 *
 * <p>Out, by {@link org.selectiverenderer.app.stream.StreamSender}: three streams, of poses (each
 * frame), of the object looked at (each change) and of events. In, by {@link
 * org.selectiverenderer.app.stream.StreamRecorder}: streams of other programs, written beside the
 * head logs with their clock offsets.
 *
 * <pre>
 *   stepping thread -- samples --> queue -> thread lsl-out -> outlets -> network
 *   journal, time line -- events -^
 *   network -> inlets -> thread lsl-in -> streams/NAME_run-NN.csv, .offsets.csv, .json
 * </pre>
 *
 * <p>The two threads are the only ones that call the library; only the end of the session waits for
 * them. {@link org.selectiverenderer.app.stream.LslStreams} owns both. Uses {@code lsl}, {@code
 * app.head} for the samples, {@code walkthrough.timeline}, {@code study.headlog} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.app.stream;

import org.jspecify.annotations.NullMarked;
