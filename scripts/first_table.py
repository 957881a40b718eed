"""The first table of an HTML page on standard input, as Markdown."""
import sys
from html.parser import HTMLParser


class FirstTable(HTMLParser):
    def __init__(self):
        super().__init__()
        self.rows, self.open, self.is_over = [], False, False

    def handle_starttag(self, tag, attributes):
        if self.is_over:
            return
        if tag == 'tr':
            self.rows.append([])
        elif tag in ('th', 'td'):
            self.rows[-1].append('')
            self.open = True

    def handle_endtag(self, tag):
        self.is_over |= tag == 'table'
        self.open &= tag not in ('th', 'td')

    def handle_data(self, data):
        if self.open and not self.is_over:
            self.rows[-1][-1] += data


table = FirstTable()
table.feed(sys.stdin.read())
table.rows.insert(1, ['---'] * len(table.rows[0]))
for row in table.rows:
    print('|', ' | '.join(cell.strip() for cell in row), '|')
