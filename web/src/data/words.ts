/** The words that participants read about their data. */
export interface DataWords {
  readonly sending: string;
  readonly trouble: string;
  readonly save: string;
  readonly saved: string;
  readonly leave: string;
  /** For browsers that keep nothing over a closed tab. */
  readonly notKept: string;
}

const ENGLISH: DataWords = {
  sending: 'Your answers are being sent. Please leave this page open.',
  trouble: 'The answers cannot be sent at the moment. Please leave this page open: it tries again by itself.',
  save: 'Save my answers as a file',
  saved: 'Please send the saved file to the researchers. You can leave then.',
  leave: 'Leave',
  notKept: 'This browser keeps nothing when a page is closed. Please leave this page open until the end.',
};

const GREEK: DataWords = {
  sending: 'Οι απαντήσεις σας αποστέλλονται. Παρακαλούμε αφήστε τη σελίδα ανοιχτή.',
  trouble: 'Οι απαντήσεις δεν μπορούν να σταλούν αυτή τη στιγμή. Παρακαλούμε αφήστε τη σελίδα ανοιχτή: ξαναπροσπαθεί μόνη της.',
  save: 'Αποθήκευση των απαντήσεών μου σε αρχείο',
  saved: 'Παρακαλούμε στείλτε το αποθηκευμένο αρχείο στους ερευνητές. Μετά μπορείτε να φύγετε.',
  leave: 'Αποχώρηση',
  notKept: 'Ο φυλλομετρητής δεν κρατά τίποτε όταν κλείνει μια σελίδα. Παρακαλούμε αφήστε τη σελίδα ανοιχτή ως το τέλος.',
};

/** Returns the words of a language by its code, such as el or en-GB. */
export function dataWords(language: string): DataWords {
  return language.toLowerCase().startsWith('el') ? GREEK : ENGLISH;
}
